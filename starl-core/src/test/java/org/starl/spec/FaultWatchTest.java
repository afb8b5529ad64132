package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

class FaultWatchTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");

  private final FaultWatch faults = new FaultWatch();

  private void see(RobotId robot, String name) {
    faults.observe(new Fault(1, robot, name, ""));
  }

  @Test
  void theWorldBehavesBeforeTheFirstFaultAndAfterTheLast() {
    assertThat(faults.isCalm()).isTrue();
    see(Fault.WORLD, Fault.BEGIN);
    assertThat(faults.isCalm()).isFalse();
    see(Fault.WORLD, Fault.END);
    assertThat(faults.isCalm()).as("another may come").isFalse();
    see(Fault.WORLD, Fault.HEALED);
    assertThat(faults.isCalm()).isTrue();
  }

  @Test
  void whoCrashedIsDownUntilItRestartsOrLeaves() {
    see(BOT1, Fault.CRASH);
    see(BOT0, Fault.CRASH);
    assertThat(faults.down()).containsExactly(BOT0, BOT1);
    assertThat(faults.isDown(BOT0)).isTrue();
    see(BOT0, Fault.RESTART);
    assertThat(faults.isDown(BOT0)).isFalse();
    faults.observe(new TraceEvent.Left(2, BOT1));
    assertThat(faults.down()).isEmpty();
  }
}
