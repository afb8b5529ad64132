package org.starl.apps.search.logic;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.id.RobotId;
import org.starl.platform.Sighting;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a search. */
public sealed interface SearchFact {

  /** Where the program is. */
  Var<SearchApp.Location> LOCATION = Var.of("location", SearchApp.Location.class);

  /** The room that this robot searches or drives to; empty for none. */
  Var<String> ROOM = Var.of("room", TEXT);

  /** What this robot has assigned, if it leads. */
  Var<Assigned> DUTY = Var.of("duty", Assigned.SHAPE);

  /** The rooms that this robot knows to be searched in full. */
  Var<Rooms> SWEPT = Var.of("swept", Rooms.SHAPE);

  /** This robot has searched a room in full. */
  record Swept(String room) implements SearchFact {}

  /** This robot has planned the sweep of a room, or of a part of it. */
  record Planned(String room, List<Leg> legs) implements SearchFact {
    public Planned {
      legs = List.copyOf(legs);
    }
  }

  /**
   * A thing was seen.
   *
   * @param xMm its place
   * @param withinMm how far off the place and the robot's position may be together, beyond
   *     rounding; 0 if the sensor is exact
   */
  record Found(String thing, long xMm, long yMm, long withinMm) implements SearchFact {

    /**
     * What a sensor shows.
     *
     * @param errorMm error bound of the robot's position
     */
    static Found of(Sighting thing, double errorMm) {
      long withinMm = thing.errorMm() == 0 ? 0 : (long) Math.ceil(thing.errorMm() + errorMm);
      return new Found(
          thing.name(), Math.round(thing.at().xMm()), Math.round(thing.at().yMm()), withinMm);
    }

    /** The place. */
    public Point at() {
      return new Point(xMm, yMm);
    }
  }

  /** This robot ends with this answer. */
  record Ended(Answer answer) implements SearchFact {}

  /** A leg of a sweep, in whole mm; a stop if its ends are equal. */
  record Leg(Point from, Point to) {

    private static final int MOST = 0xFFFF;

    /** The shape of a sweep's legs. */
    static final Shape<List<Leg>> LIST =
        Shapes.list(
            Shapes.of(
                Leg.class,
                part("from", Geometry.POINT, Leg::from),
                part("to", Geometry.POINT, Leg::to),
                Leg::new),
            MOST);

    static Leg of(Segment leg) {
      return new Leg(rounded(leg.from()), rounded(leg.to()));
    }

    private static Point rounded(Point point) {
      return new Point(Math.round(point.xMm()), Math.round(point.yMm()));
    }

    /** {@code 500,1500>900,1500}, or {@code 700,700} for a stop. */
    @Override
    public String toString() {
      return text(from) + (from.equals(to) ? "" : ">" + text(to));
    }

    private static String text(Point point) {
      return (long) point.xMm() + "," + (long) point.yMm();
    }
  }

  /**
   * A leader's assignments.
   *
   * @param term in which it leads, from 1; 0 if it does not lead
   * @param rooms the name of the room of each robot that has one
   */
  record Assigned(long term, SortedMap<RobotId, String> rooms) {

    /** This robot does not lead. */
    public static final Assigned NONE = new Assigned(0, Collections.emptySortedMap());

    private static final int MOST = 255;

    static final Shape<Assigned> SHAPE =
        Shapes.of(
            Assigned.class,
            part("term", LONG, Assigned::term),
            part("rooms", Shapes.map(ROBOT, TEXT, MOST), Assigned::rooms),
            Assigned::new);

    public Assigned {
      rooms = Collections.unmodifiableSortedMap(new TreeMap<>(rooms));
    }

    /** Whether the robot leads. */
    public boolean isLeading() {
      return term > 0;
    }

    /** {@code 3 bot1=A bot2=C}: the term, then the rooms; empty if the robot does not lead. */
    @Override
    public String toString() {
      if (!isLeading()) {
        return "";
      }
      StringBuilder text = new StringBuilder().append(term);
      rooms.forEach((robot, room) -> text.append(' ').append(robot).append('=').append(room));
      return text.toString();
    }
  }

  /** Names of rooms, in the order of the house. */
  record Rooms(List<String> names) {

    static final Shape<Rooms> SHAPE =
        Shapes.of(
            Rooms.class,
            part("names", Shapes.list(TEXT, Report.MAX_ROOMS), Rooms::names),
            Rooms::new);

    public Rooms {
      names = List.copyOf(names);
    }

    /** The names, with a space between two. */
    @Override
    public String toString() {
      return String.join(" ", names);
    }
  }

  /** The shapes of all facts, under their names in the trace. */
  SumShape<SearchFact> SHAPE =
      Shapes.oneOf(
          SearchFact.class,
          Shapes.of(Swept.class, part("room", TEXT, Swept::room), Swept::new).named("swept"),
          Shapes.of(
                  Planned.class,
                  part("room", TEXT, Planned::room),
                  part("legs", Leg.LIST, Planned::legs),
                  Planned::new)
              .named("sweep"),
          Shapes.of(
                  Found.class,
                  part("thing", TEXT, Found::thing),
                  part("xMm", LONG, Found::xMm),
                  part("yMm", LONG, Found::yMm),
                  part("withinMm", LONG, Found::withinMm),
                  Found::new)
              .named("found"),
          Shapes.of(Ended.class, part("answer", Answer.SHAPE, Ended::answer), Ended::new)
              .named("answer"));

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL
          .messages(GeocastFact.BROADCAST, GeocastMessage.shape(Report.shape(Report.MAX_ROOMS)))
          .facts(Instance.APP.primitive(), SHAPE)
          .variables(Instance.APP.primitive(), LOCATION, ROOM, DUTY, SWEPT);
}
