package org.starl.primitives.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.body.MotionParameters;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

class MotionSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final long MS = 1_000_000;
  private static final Pose HERE = new Pose(0, 0, 0);

  private final Monitors monitors =
      new Monitors(
          List.of(new MotionSpec(MotionParameters.DEFAULT.toBuilder().reactionMs(50).build())));

  @Test
  void aRobotThatStopsInTimeStands() {
    drivesAndHas("FAIL");
    monitors.observe(new Moved(1_049 * MS, A, HERE, 0, 0));
    monitors.observe(new Variable(2_000 * MS, A, MotionTrace.SOURCE, "motionflag", "MOVING"));
    monitors.observe(new Moved(2_000 * MS, A, HERE, 100, 0));
    monitors.finish(5_000 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aRobotThatDrivesOnAfterAFailureViolatesTold() {
    drivesAndHas("FAIL");
    monitors.finish(1_051 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotThatTurnsAgainAfterMotionStopViolatesTold() {
    drivesAndHas("IDLE");
    monitors.observe(new Moved(1_000 * MS, A, HERE, 0, 0));
    monitors.observe(new Moved(3_000 * MS, A, HERE, 0, 1));
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotOfARunInRealTimeMayStopLate() {
    monitors.observe(new Fault(0, Fault.WORLD, Fault.BEGIN, Fault.REAL_TIME));
    drivesAndHas("FAIL");
    monitors.finish(5_000 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  private void drivesAndHas(String flag) {
    monitors.observe(new Joined(0, A, HERE, 165));
    monitors.observe(new Moved(0, A, HERE, 100, 0));
    monitors.observe(new Variable(1_000 * MS, A, MotionTrace.SOURCE, "motionflag", flag));
  }
}
