package org.starl.primitives.paths;

import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import org.starl.primitives.Phases;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of tubes. */
public sealed interface TubeFact {

  /** The kind of the instances of {@link DistributedPathPlanning}. */
  String PRIMITIVE = "tubes";

  /** The tubes that the robot holds. */
  Var<TubeList> HELD = Var.of("held", TubeList.SHAPE);

  /** The state of the latest {@code goTo}. */
  Var<TubeFlag> FLAG = Var.of("tubeflag", TubeFlag.class);

  /** Why the latest {@code goTo} failed. */
  Var<TubeFailure> FAILURE = Var.of("failure", TubeFailure.class);

  /** A call of {@code goTo} or {@code goAlong}. */
  record goTo(TubeGoal goal) implements TubeFact {}

  /** The robot will hold only {@code rest}; it takes its place to be this one, within the error bound. */
  record frees(TubeList rest, double xMm, double yMm, double errorMm) implements TubeFact {}

  /** The shapes of all facts. */
  SumShape<TubeFact> SHAPE =
      Shapes.oneOf(
          TubeFact.class,
          Shapes.of(goTo.class, part("goal", TubeGoal.SHAPE, goTo::goal), goTo::new),
          Shapes.of(
              frees.class,
              part("rest", TubeList.SHAPE, frees::rest),
              part("xMm", REAL, frees::xMm),
              part("yMm", REAL, frees::yMm),
              part("errorMm", REAL, frees::errorMm),
              frees::new));

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, TubeMessage.SHAPE)
          .facts(PRIMITIVE, SHAPE)
          .variables(PRIMITIVE, HELD, FLAG, FAILURE);

  /** The phases are the values of {@link TubeFlag}. */
  Phases PHASES =
      Phases.of(PRIMITIVE, TubeMessage.class, () -> TubeFact::phase, (Object[]) TubeFlag.values());

  private static String phase(String before, TraceEvent event) {
    TubeFlag flag = event instanceof TraceEvent.Variable variable ? variable.of(FLAG) : null;
    return flag == null ? before : flag.name();
  }
}
