package org.starl.primitives.geocast;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.part;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Region;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of geocasts and broadcasts. Names are the paper's and the theory's. */
public sealed interface GeocastFact {

  /** The kind of the instances of {@link Geocast}. */
  String GEOCAST = "geocast";

  /** The kind of the instances of {@link Broadcast}. */
  String BROADCAST = "broadcast";

  /** The paper's {@code Gcastflag}: whether this robot's messages are complete. */
  Var<Boolean> GCASTFLAG = Var.of("Gcastflag", Shapes.BOOL);

  /** The robot takes part from now on, and has delivered nothing. */
  record Opened(ProcessId me) implements GeocastFact {}

  /**
   * A geocast starts.
   *
   * @param bound the paper's d, in ns
   */
  record do_geocast(GeocastId m, Region area, long bound) implements GeocastFact {}

  /** A broadcast starts, which is a geocast to everywhere. */
  record BCast(GeocastId m, Region area, long bound) implements GeocastFact {}

  /** The robot passes a copy to its radio. */
  record copy(GeocastId m) implements GeocastFact {}

  /** The app receives the message. */
  record deliver(GeocastId m) implements GeocastFact {}

  /**
   * An arrived copy is not delivered.
   *
   * @param errorMm the error bound of the robot's position; infinite before its first fix
   */
  record dismiss(GeocastId m, Dismissal reason, double errorMm) implements GeocastFact {}

  /** A length that may be infinite, for which JSON has no number. */
  Shape<Double> BOUND_MM = Shapes.text("mm", String::valueOf, Double::valueOf);

  /** The shapes of all facts. */
  SumShape<GeocastFact> SHAPE =
      Shapes.oneOf(
          GeocastFact.class,
          Shapes.of(Opened.class, part("me", Shapes.PROCESS, Opened::me), Opened::new)
              .named("open"),
          Shapes.of(
              do_geocast.class,
              part("m", GeocastId.SHAPE, do_geocast::m),
              part("area", Geometry.REGION, do_geocast::area),
              part("bound", LONG, do_geocast::bound),
              do_geocast::new),
          Shapes.of(
              BCast.class,
              part("m", GeocastId.SHAPE, BCast::m),
              part("area", Geometry.REGION, BCast::area),
              part("bound", LONG, BCast::bound),
              BCast::new),
          Shapes.of(copy.class, part("m", GeocastId.SHAPE, copy::m), copy::new),
          Shapes.of(deliver.class, part("m", GeocastId.SHAPE, deliver::m), deliver::new),
          Shapes.of(
              dismiss.class,
              part("m", GeocastId.SHAPE, dismiss::m),
              part("reason", Shapes.constant(Dismissal.class), dismiss::reason),
              part("errorMm", BOUND_MM, dismiss::errorMm),
              dismiss::new));

  /** What a reader of traces needs; to it, the apps' messages in the copies are plain JSON. */
  Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(GEOCAST, GeocastMessage.shape(Shapes.JSON))
          .messages(BROADCAST, GeocastMessage.shape(Shapes.JSON))
          .facts(GEOCAST, SHAPE)
          .facts(BROADCAST, SHAPE)
          .variables(GEOCAST, GCASTFLAG)
          .variables(BROADCAST, GCASTFLAG);

  /** Whether the sending of a message of this robot is incomplete. */
  enum Phase {
    IDLE,
    CASTING
  }

  /** The {@link Phase} of a geocast. */
  Phases PHASES =
      Phases.of(GEOCAST, GeocastMessage.class, () -> GeocastFact::phase, (Object[]) Phase.values());

  /** The {@link Phase} of a broadcast. */
  Phases BROADCAST_PHASES =
      Phases.of(
          BROADCAST, GeocastMessage.class, () -> GeocastFact::phase, (Object[]) Phase.values());

  private static String phase(String before, TraceEvent event) {
    return switch (event) {
      case Action action when action.fact() instanceof do_geocast -> Phase.CASTING.name();
      case Action action when action.fact() instanceof BCast -> Phase.CASTING.name();
      case Variable variable when Boolean.TRUE.equals(variable.of(GCASTFLAG)) -> Phase.IDLE.name();
      default -> before;
    };
  }

  /** The action of the theory that robot {@code i} takes by a fact; null if it takes none. */
  static @Nullable GeocastAction action(GeocastFact fact, RobotId i) {
    return switch (fact) {
      case Opened f -> new GeocastAction.restart(i);
      case do_geocast f -> start(f.m, f.area, f.bound);
      case BCast f -> start(f.m, f.area, f.bound);
      case deliver f -> new GeocastAction.deliver(f.m.toString(), i);
      case copy f -> null;
      case dismiss f -> null;
    };
  }

  private static GeocastAction start(GeocastId m, Region area, long bound) {
    Area named = area instanceof Everywhere ? Area.EVERYWHERE : Area.of(m);
    return new GeocastAction.do_geocast(m.toString(), named, bound);
  }
}
