package org.starl.apps.intersection.logic;

import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a car: its trip, and the variables of its program. */
public final class CrossingFact {

  /** The location of {@link IntersectionApp}. */
  public static final Var<Location> LOCATION = Var.of("location", Location.class);

  /** The zones that still lie ahead. */
  public static final Var<List<String>> MYSEQ = Var.of("myseq", Way.ZONES);

  /**
   * The program starts, or finds out after a restart where it is.
   *
   * @param label for people, as in {@link Trip}
   * @param route the whole route, if it is one of the twelve
   * @param zones the zones ahead
   */
  public record Way(String label, Optional<Route> route, List<String> zones) {

    private static final Shape<List<String>> ZONES = Shapes.list(TEXT, 0xFF);

    /** The shape of trips, under their name in the trace. */
    public static final RecordShape<Way> SHAPE =
        Shapes.of(
                Way.class,
                part("label", TEXT, Way::label),
                part("route", Shapes.optional(Route.SHAPE), Way::route),
                part("zones", ZONES, Way::zones),
                Way::new)
            .named("trip");

    public Way {
      zones = List.copyOf(zones);
    }

    /** The rest of a trip. */
    public static Way of(Trip trip, List<String> zones) {
      return new Way(trip.label(), trip.route(), zones);
    }
  }

  /** What a reader of traces needs for cars with the program of Figure 4. */
  public static final Vocabulary FIGURE_4 =
      PrimitiveVocabulary.ALL
          .facts(Instance.APP.primitive(), Way.SHAPE)
          .variables(Instance.APP.primitive(), LOCATION, MYSEQ);

  /** What a reader of traces needs for cars with the program of Figure 3. */
  public static final Vocabulary FIGURE_3 =
      FIGURE_4.variables(
          Instance.APP.primitive(), IcpProgram.LOCATION, IcpProgram.PLIST, IcpProgram.MYSEQ);

  private CrossingFact() {}

  /** The event as a trip, if it is one. */
  public static Optional<Way> trip(TraceEvent event) {
    return event instanceof Action action && action.fact() instanceof Way way
        ? Optional.of(way)
        : Optional.empty();
  }

  /** The location that the event's robot has now, if the event changes it. */
  public static Optional<Location> location(TraceEvent event) {
    if (!(event instanceof Variable variable)) {
      return Optional.empty();
    }
    Location location = variable.of(LOCATION);
    return Optional.ofNullable(location == null ? figure3(variable) : location);
  }

  // Where the names of IcpProgram, which are Figure 3's, differ from those of IntersectionApp. At
  // S0 a restarted program finds out what lies ahead, as IntersectionApp does in RESUME.
  private static @Nullable Location figure3(Variable variable) {
    IcpProgram.Location location = variable.of(IcpProgram.LOCATION);
    return location == null ? null : figure4(location);
  }

  /** The location of Figure 4 that is this one of Figure 3. */
  public static Location figure4(IcpProgram.Location location) {
    return switch (location) {
      case S0 -> Location.RESUME;
      case REG_WAIT -> Location.REGISTER_WAIT;
      case MUTEX_WAIT -> Location.MUTEX_WAIT;
      case MOVE_WAIT -> Location.MOVE_WAIT;
      case S1 -> Location.S_1;
      case UNREG_WAIT -> Location.UNREGISTER_WAIT;
      case DONE -> Location.DONE;
    };
  }

  /** The zones ahead of the event's robot, if the event changes them. */
  public static Optional<List<String>> myseq(TraceEvent event) {
    if (!(event instanceof Variable variable)) {
      return Optional.empty();
    }
    List<String> zones = variable.of(MYSEQ);
    return Optional.ofNullable(zones == null ? variable.of(IcpProgram.MYSEQ) : zones);
  }

  /** Whether the event's robot was stopped on its way: a bump, no fix, stuck wheels. */
  public static boolean isStopped(TraceEvent event) {
    return event instanceof Variable variable && variable.of(MotionFact.FLAG) == MotionFlag.FAIL;
  }
}
