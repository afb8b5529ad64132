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

  private final FaultState circumstances = new FaultState();

  @Test
  void initiallyAllRobotsAreUpWithoutFaults() {
    assertThat(circumstances.isUp(A)).isTrue();
    assertThat(circumstances.isFaultFree()).isTrue();
  }

  @Test
  void aCrashedRobotIsDownUntilItRestarts() {
    assertThat(sees(A, Fault.CRASH, "")).isTrue();
    assertThat(circumstances.isUp(A)).isFalse();
    assertThat(circumstances.isFaultFree()).as("a crash is counted by who is up").isTrue();
    assertThat(sees(A, Fault.RESTART, "lost")).isTrue();
    assertThat(circumstances.isUp(A)).isTrue();
  }

  @Test
  void aRobotThatLeftIsDownUntilItJoins() {
    assertThat(circumstances.observe(new Left(1, A))).isTrue();
    assertThat(circumstances.isUp(A)).isFalse();
    assertThat(circumstances.observe(new Joined(2, A, new Pose(0, 0, 0), 165))).isTrue();
    assertThat(circumstances.isUp(A)).isTrue();
  }

  @Test
  void noFaultIsActiveAfterEveryFaultHasEnded() {
    sees(Fault.WORLD, Fault.BEGIN, "loss 0.3");
    sees(A, Fault.BEGIN, "slow");
    assertThat(sees(Fault.WORLD, Fault.END, "loss 0.3")).isTrue();
    assertThat(circumstances.isFaultFree()).isFalse();
    assertThat(sees(A, Fault.END, "slow")).isTrue();
    assertThat(circumstances.isFaultFree()).isTrue();
  }

  @Test
  void equalFaultsEndOneByOne() {
    sees(Fault.WORLD, Fault.BEGIN, "loss(0.3)");
    sees(Fault.WORLD, Fault.BEGIN, "loss(0.3)");
    sees(Fault.WORLD, Fault.END, "loss(0.3)");
    assertThat(circumstances.isFaultFree()).isFalse();
    sees(Fault.WORLD, Fault.END, "loss(0.3)");
    assertThat(circumstances.isFaultFree()).isTrue();
  }

  @Test
  void healingEndsAllFaultsButRestartsNoRobot() {
    sees(Fault.WORLD, Fault.BEGIN, "loss 0.3");
    sees(A, Fault.CRASH, "");
    assertThat(sees(Fault.WORLD, Fault.HEALED, "")).isTrue();
    assertThat(circumstances.isFaultFree()).isTrue();
    assertThat(circumstances.isUp(A)).isFalse();
  }

  @Test
  void otherEventsChangeNothing() {
    assertThat(circumstances.observe(new TraceEvent.Dropped(1, A, "b", "loss"))).isFalse();
  }

  private boolean sees(RobotId robot, String name, String detail) {
    return circumstances.observe(new Fault(1, robot, name, detail));
  }
}
