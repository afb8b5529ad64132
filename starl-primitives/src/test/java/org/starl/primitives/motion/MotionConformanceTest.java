package org.starl.primitives.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.MotionParameters;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.motion.MotionFlag;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.motion.MotionControlAutomaton.States;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/** The map from events to actions, line by line, and traces that are no runs of the theory. */
class MotionConformanceTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final long S = 1_000_000_000L;
  private static final ItemPosition AHEAD = new ItemPosition("ahead", 2000, 0);
  private static final Region BESIDE = new Circle(new Point(1000, 900), 200);
  private static final Region IN_THE_WAY = new Circle(new Point(1000, 0), 200);

  private final ShownRun<States, MotionControlAction> run =
      new ShownRun<>(steps -> new MotionConformance(MotionParameters.DEFAULT, steps));

  private void isAt(double xMm) {
    run.has(new Joined(0, BOT, new Pose(xMm, 0, 0), 165));
  }

  private void acts(long timeNs, MotionFact fact) {
    run.has(Action.of(timeNs, BOT, MotionFact.SOURCE, MotionFact.SHAPE, fact));
  }

  private void says(long timeNs, MotionFlag flag) {
    run.has(new Variable(timeNs, BOT, MotionFact.SOURCE, MotionFact.FLAG, flag));
  }

  private void drives(long timeNs, double xMm, double mmPerS) {
    run.has(new Moved(timeNs, BOT, new Pose(xMm, 0, 0), mmPerS, 0));
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    isAt(0);
    says(0, MotionFlag.IDLE);
    acts(0, new MotionFact.do_move(AHEAD, BESIDE));
    acts(0, new MotionFact.doMove(AHEAD, BESIDE));
    says(0, MotionFlag.MOVING);
    drives(0, 0, 500);
    drives(4 * S, 2000, 0);
    acts(4 * S, new MotionFact.arrived(2000, 0, 10));
    says(4 * S, MotionFlag.DONE);
    acts(5 * S, new MotionFact.turnTo(new ItemPosition("back", 0, 0)));
    says(5 * S, MotionFlag.MOVING);
    acts(6 * S, new MotionFact.failed(MotionFailure.BUMPED));
    says(6 * S, MotionFlag.FAIL);
    acts(7 * S, new MotionFact.motion_stop());
    says(7 * S, MotionFlag.IDLE);
    acts(8 * S, new MotionFact.doMove(AHEAD, new Nowhere()));
    says(8 * S, MotionFlag.MOVING);
    run.has(new Fault(9 * S, BOT, Fault.CRASH, ""));
    says(10 * S, MotionFlag.IDLE);
    acts(11 * S, new MotionFact.doMove(AHEAD, new Nowhere()));
    says(12 * S, MotionFlag.IDLE);
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "motionflag(bot0) = IDLE",
            "do_move(bot0, 1, 1)",
            "motionflag(bot0) = MOVING",
            "move(bot0, in [], near [1])",
            "arrived(bot0)",
            "motionflag(bot0) = DONE",
            "do_move(bot0, 2, 2)",
            "motionflag(bot0) = MOVING",
            "failed(bot0)",
            "motionflag(bot0) = FAIL",
            "motion_stop(bot0)",
            "motionflag(bot0) = IDLE",
            "do_move(bot0, 3, 3)",
            "motionflag(bot0) = MOVING",
            "motion_stop(bot0)",
            "motionflag(bot0) = IDLE",
            "do_move(bot0, 4, 4)",
            "motion_stop(bot0)",
            "motionflag(bot0) = IDLE");
  }

  @Test
  void aCommandInsideItsAreaHasNothingToAvoid() {
    isAt(900);
    acts(0, new MotionFact.doMove(AHEAD, IN_THE_WAY));
    drives(0, 900, 500);
    run.ends(S);
    assertThat(run.details()).isEmpty();
    assertThat(run.steps()).containsExactly("do_move(bot0, 1, 0)");
  }

  @Test
  void aBodyPutDownInTheAreaIsNoAction() {
    isAt(0);
    acts(0, new MotionFact.doMove(AHEAD, IN_THE_WAY));
    run.has(new Left(S, BOT));
    run.has(new Joined(2 * S, BOT, new Pose(1000, 0, 0), 165));
    run.ends(3 * S);
    assertThat(run.details()).isEmpty();
    assertThat(run.steps()).containsExactly("do_move(bot0, 1, 1)");
  }

  @Test
  void enteringTheAreaDeviates() {
    isAt(0);
    acts(0, new MotionFact.doMove(AHEAD, IN_THE_WAY));
    says(0, MotionFlag.MOVING);
    drives(0, 0, 500);
    run.ends(2 * S);
    assertThat(run.details())
        .containsExactly(
            "motion: move(bot0, in [1], near []) is not enabled: not motionflag(i) = IDLE =>"
                + " not p in avoid(i) is false: motionflag(bot0) = MOVING, avoid(bot0) = 1");
    // The body's border reaches the area after 635 mm.
    assertThat(run.report().violations().get(0).timeNs()).isBetween(1_270_000_000L, 1_272_000_000L);
  }

  @Test
  void enteringTheAreaAfterAFailureDeviates() {
    isAt(0);
    acts(0, new MotionFact.doMove(AHEAD, IN_THE_WAY));
    says(0, MotionFlag.MOVING);
    says(0, MotionFlag.FAIL);
    drives(S, 0, 500);
    drives(3 * S, 1000, 0);
    assertThat(run.details()).hasSize(1);
  }

  @Test
  void aStoppedRobotMayMoveAnywhere() {
    isAt(0);
    acts(0, new MotionFact.doMove(AHEAD, IN_THE_WAY));
    acts(0, new MotionFact.motion_stop());
    drives(0, 0, 500);
    run.ends(2 * S);
    assertThat(run.details()).isEmpty();
  }

  @Test
  void doneAwayFromTheTargetDeviates() {
    isAt(0);
    acts(0, new MotionFact.doMove(AHEAD, new Nowhere()));
    acts(S, new MotionFact.arrived(2000, 0, 10));
    says(S, MotionFlag.DONE);
    assertThat(run.details())
        .containsExactly(
            "motion: arrived(bot0) is not enabled: near(pos(i), target(i)) is false: pos(bot0) = in"
                + " [], near [], target(bot0) = 1");
  }

  @Test
  void doneOrFailWithoutACommandDeviates() {
    isAt(0);
    says(0, MotionFlag.FAIL);
    assertThat(run.details())
        .containsExactly(
            "motion: failed(bot0) is not enabled: motionflag(i) = MOVING is false: motionflag(bot0)"
                + " = IDLE");
  }

  @Test
  void aDifferentFlagDeviates() {
    isAt(0);
    says(0, MotionFlag.MOVING);
    assertThat(run.details())
        .containsExactly("motion: motionflag(bot0) is IDLE, but the trace has MOVING");
  }
}
