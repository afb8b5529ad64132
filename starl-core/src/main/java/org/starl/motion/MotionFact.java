package org.starl.motion;

import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.shape.Geometry;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of motions: commands, and how they end. Names are the paper's. */
public sealed interface MotionFact {

  /** The instance in the trace: a robot has one body. */
  Instance SOURCE = Instance.of("motion");

  /** The paper's {@code motionflag}. */
  Var<MotionFlag> FLAG = Var.of("motionflag", MotionFlag.class);

  /** The paper's pair of the last command. */
  Var<MotionTask> TASK = Var.of("(target, avoid)", MotionTask.SHAPE);

  int MOST_CORNERS = 0xFFFF;

  /** A command to the primitive of the paper, by the name in its section 4.1. */
  record gotopoint(ItemPosition target, Region avoid) implements MotionFact {}

  /** The same command, by the name in its section 2. */
  record do_move(ItemPosition target, Region avoid) implements MotionFact {}

  /** The same command to the motion automaton below, which apps may also use directly. */
  record doMove(ItemPosition target, Region avoid) implements MotionFact {}

  /** The corners of the way, the target last; empty if there is none. Not for a straight way. */
  record planned(List<Point> way) implements MotionFact {}

  /** A command: turn on the spot until the robot faces the target. */
  record turnTo(ItemPosition target) implements MotionFact {}

  /** A command: drive with this speed until the next command. */
  record doDrive(double linearMmPerS, double angularRadPerS) implements MotionFact {}

  /** A command: stop. */
  record motion_stop() implements MotionFact {}

  /** The motion is DONE, at this estimated position with this error bound. */
  record arrived(double xMm, double yMm, double errorMm) implements MotionFact {}

  /** The motion has FAILed. */
  record failed(MotionFailure reason) implements MotionFact {}

  /** The shapes of all facts. */
  SumShape<MotionFact> SHAPE =
      Shapes.oneOf(
          MotionFact.class,
          Shapes.of(
              gotopoint.class,
              part("target", Geometry.ITEM, gotopoint::target),
              part("avoid", Geometry.REGION, gotopoint::avoid),
              gotopoint::new),
          Shapes.of(
              do_move.class,
              part("target", Geometry.ITEM, do_move::target),
              part("avoid", Geometry.REGION, do_move::avoid),
              do_move::new),
          Shapes.of(
              doMove.class,
              part("target", Geometry.ITEM, doMove::target),
              part("avoid", Geometry.REGION, doMove::avoid),
              doMove::new),
          Shapes.of(
              planned.class,
              part("way", Shapes.list(Geometry.POINT, MOST_CORNERS), planned::way),
              planned::new),
          Shapes.of(turnTo.class, part("target", Geometry.ITEM, turnTo::target), turnTo::new),
          Shapes.of(
              doDrive.class,
              part("linearMmPerS", REAL, doDrive::linearMmPerS),
              part("angularRadPerS", REAL, doDrive::angularRadPerS),
              doDrive::new),
          Shapes.of(motion_stop.class, motion_stop::new),
          Shapes.of(
              arrived.class,
              part("xMm", REAL, arrived::xMm),
              part("yMm", REAL, arrived::yMm),
              part("errorMm", REAL, arrived::errorMm),
              arrived::new),
          Shapes.of(
              failed.class,
              part("reason", Shapes.constant(MotionFailure.class), failed::reason),
              failed::new));

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY =
      Vocabulary.NONE
          .facts(SOURCE.primitive(), SHAPE)
          .variables(SOURCE.primitive(), FLAG, TASK)
          .variables(Deviation.SOURCE.primitive(), Deviation.VAR);
}
