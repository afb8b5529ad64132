package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;

class FaultStateTest {

  private static final RobotId A = new RobotId("a");

  private final FaultState faults = new FaultState();

  @Test
  void initiallyAllRobotsAreUpWithoutFaults() {
    assertThat(faults.isUp(A)).isTrue();
    assertThat(faults.isFaultFree()).isTrue();
  }

  @Test
  void aCrashedRobotIsDownUntilItRestarts() {
    assertThat(sees(A, Fault.CRASH, "")).isTrue();
    assertThat(faults.isUp(A)).isFalse();
    assertThat(faults.isFaultFree()).as("a crash only changes which robots are up").isTrue();
    assertThat(sees(A, Fault.RESTART, "lost")).isTrue();
    assertThat(faults.isUp(A)).isTrue();
  }

  @Test
  void aRobotThatLeftIsDownUntilItJoins() {
    assertThat(faults.observe(new Left(1, A))).isTrue();
    assertThat(faults.isUp(A)).isFalse();
    assertThat(faults.observe(new Joined(2, A, new Pose(0, 0, 0), 165))).isTrue();
    assertThat(faults.isUp(A)).isTrue();
  }

  @Test
  void noFaultIsActiveAfterEveryFaultHasEnded() {
    sees(Fault.WORLD, Fault.BEGIN, "loss 0.3");
    sees(A, Fault.BEGIN, "slow");
    assertThat(sees(Fault.WORLD, Fault.END, "loss 0.3")).isTrue();
    assertThat(faults.isFaultFree()).isFalse();
    assertThat(sees(A, Fault.END, "slow")).isTrue();
    assertThat(faults.isFaultFree()).isTrue();
  }

  @Test
  void equalFaultsEndOneByOne() {
    sees(Fault.WORLD, Fault.BEGIN, "loss(0.3)");
    sees(Fault.WORLD, Fault.BEGIN, "loss(0.3)");
    sees(Fault.WORLD, Fault.END, "loss(0.3)");
    assertThat(faults.isFaultFree()).isFalse();
    sees(Fault.WORLD, Fault.END, "loss(0.3)");
    assertThat(faults.isFaultFree()).isTrue();
  }

  @Test
  void healingEndsAllFaultsButRestartsNoRobot() {
    sees(Fault.WORLD, Fault.BEGIN, "loss 0.3");
    sees(A, Fault.CRASH, "");
    assertThat(sees(Fault.WORLD, Fault.HEALED, "")).isTrue();
    assertThat(faults.isFaultFree()).isTrue();
    assertThat(faults.isUp(A)).isFalse();
  }

  @Test
  void aCrashWithARestartIsNoActiveFault() {
    faults.observe(new Fault(1, A, Fault.BEGIN, Fault.CRASH, "crash(any,at=1s,restart=9s)"));
    sees(A, Fault.CRASH, "");
    assertThat(faults.isFaultFree()).isTrue();
    assertThat(faults.isUp(A)).isFalse();
    assertThat(faults.isCalm(1_000, 10)).isFalse();
  }

  @Test
  void aRunWithAGivenFateOfADatagramIsNeverCalm() {
    Fault begins = new Fault(1, A, Fault.BEGIN, "datagram", "datagram(a>b,25,lost)");
    faults.observe(begins);
    faults.observe(new Fault(1, A, Fault.END, begins.effect(), begins.detail()));
    faults.observe(new Fault(1, Fault.WORLD, Fault.HEALED, ""));
    assertThat(faults.isFaultFree()).isTrue();
    assertThat(faults.isCalm(1_000, 10)).isFalse();
    assertThat(faults.copy().isCalm(1_000, 10)).isFalse();
  }

  @Test
  void otherEventsChangeNothing() {
    assertThat(faults.observe(new TraceEvent.Dropped(1, A, "b", "loss"))).isFalse();
  }

  private boolean sees(RobotId robot, String name, String detail) {
    return faults.observe(new Fault(1, robot, name, detail));
  }
}
