package org.starl.apps.race.logic;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a race. */
public final class RaceFact {

  /** Where the program is. */
  public static final Var<RaceApp.Location> LOCATION = Var.of("location", RaceApp.Location.class);

  /** The name of the point to which the robot races; empty if there is none. */
  public static final Var<String> POINT = Var.of("point", TEXT);

  /**
   * The robot has arrived at a point.
   *
   * @param point its number
   * @param name its name
   * @param offMm the robot's estimated distance from it
   * @param errorMm the error bound of that
   * @param withinMm the distance from which it may win
   */
  public record Arrived(int point, String name, double offMm, double errorMm, double withinMm) {

    /** The shape of arrivals, under their name in the trace. */
    public static final RecordShape<Arrived> SHAPE =
        Shapes.of(
                Arrived.class,
                part("point", INT, Arrived::point),
                part("name", TEXT, Arrived::name),
                part("offMm", REAL, Arrived::offMm),
                part("errorMm", REAL, Arrived::errorMm),
                part("withinMm", REAL, Arrived::withinMm),
                Arrived::new)
            .named("arrive");
  }

  /**
   * The robot knows a claim that is the first, or better than the one before.
   *
   * @param point the number of the point
   * @param name the name of the point
   */
  public record Taken(int point, String name, RobotId winner, long atNs, int keptOffMm) {

    /** The shape of these facts, under their name in the trace. */
    public static final RecordShape<Taken> SHAPE =
        Shapes.of(
                Taken.class,
                part("point", INT, Taken::point),
                part("name", TEXT, Taken::name),
                part("winner", ROBOT, Taken::winner),
                part("atNs", LONG, Taken::atNs),
                part("keptOffMm", INT, Taken::keptOffMm),
                Taken::new)
            .named("taken");

    static Taken of(Claim claim, RacePoint point) {
      return new Taken(
          claim.point(), point.name(), claim.winner(), claim.atNs(), claim.keptOffMm());
    }

    /** The claim. */
    public Claim claim() {
      return new Claim(point, winner, atNs, keptOffMm);
    }
  }

  /** A robot, at this distance, has the way to a point from now on, as far as the one that says so knows. */
  public record Way(RobotId robot, int point, int distanceMm) {

    /** The shape of these facts, under their name in the trace. */
    public static final RecordShape<Way> SHAPE =
        Shapes.of(
                Way.class,
                part("robot", ROBOT, Way::robot),
                part("point", INT, Way::point),
                part("distanceMm", INT, Way::distanceMm),
                Way::new)
            .named("way");
  }

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL
          .messages(
              GeocastFact.BROADCAST, GeocastMessage.shape(RaceMessage.shape(RaceMessage.MOST)))
          .messages(GeocastFact.GEOCAST, GeocastMessage.shape(RightOfWay.Ask.SHAPE))
          .facts(Instance.APP.primitive(), Arrived.SHAPE, Taken.SHAPE, Way.SHAPE)
          .variables(Instance.APP.primitive(), LOCATION, POINT);

  private RaceFact() {}

  /** The claim of a {@link Taken}; null if the event is none. */
  public static @Nullable Claim taken(TraceEvent event) {
    return event instanceof Action action && action.fact() instanceof Taken taken
        ? taken.claim()
        : null;
  }
}
