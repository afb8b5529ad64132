package org.starl.apps.maze.logic;

import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.stream.Collectors;
import org.starl.comms.Channel;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.primitives.paths.Path;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a robot in a maze. */
public sealed interface MazeFact {

  /** Where the program is. */
  Var<MazeApp.Location> LOCATION = Var.of("location", MazeApp.Location.class);

  /** The name of the goal that the robot drives to; empty at the end. */
  Var<String> TOWARD = Var.of("toward", TEXT);

  /** The intended way. */
  Var<Way> WAY = Var.of("way", Way.SHAPE);

  /**
   * A goal is answered.
   *
   * @param goal its name
   * @param errorMm the error bound of the robot's position
   */
  record Answered(String goal, Answer answer, double errorMm) implements MazeFact {}

  /** A contact has proven that no body that is wider by the margin has its centre in the place. */
  record Marked(Polygon place) implements MazeFact {}

  /**
   * A way for the picture.
   *
   * @param points in whole mm; none if the robot intends no way
   */
  record Way(List<Point> points) {

    private static final int MOST_POINTS = 0xFFFF;

    /** The shape of ways. */
    static final Shape<Way> SHAPE =
        Shapes.of(
            Way.class,
            part("points", Shapes.list(Geometry.POINT, MOST_POINTS), Way::points),
            Way::new);

    /** No way is intended. */
    static final Way NONE = new Way(List.of());

    public Way {
      points = List.copyOf(points);
    }

    static Way of(Path path) {
      return new Way(path.points().stream().map(Way::rounded).collect(Collectors.toList()));
    }

    private static Point rounded(Point at) {
      return new Point(Math.round(at.xMm()), Math.round(at.yMm()));
    }

    /** The points, as in {@code 500,1500>900,1500}. */
    @Override
    public String toString() {
      return points.stream()
          .map(at -> (long) at.xMm() + "," + (long) at.yMm())
          .collect(Collectors.joining(">"));
    }
  }

  /** The shapes of all facts, under their names in the trace. */
  SumShape<MazeFact> SHAPE =
      Shapes.oneOf(
          MazeFact.class,
          Shapes.of(
                  Answered.class,
                  part("goal", TEXT, Answered::goal),
                  part("answer", Shapes.constant(Answer.class), Answered::answer),
                  part("errorMm", REAL, Answered::errorMm),
                  Answered::new)
              .named("answer"),
          Shapes.of(Marked.class, part("place", polygon(), Marked::place), Marked::new)
              .named("mark"));

  private static Shape<Polygon> polygon() {
    return Shapes.of(
        Polygon.class,
        part("vertices", Shapes.list(Geometry.POINT, Way.MOST_POINTS), Polygon::vertices),
        Polygon::new);
  }

  /** Marks that a robot has proven, for the others. */
  Channel<Mark> MARKS =
      Channel.of(
          "marks",
          Shapes.of(
              Mark.class,
              part("at", Geometry.POINT, Mark::at),
              part("errorMm", REAL, Mark::errorMm),
              part("fromRad", REAL, Mark::fromRad),
              part("sweepRad", REAL, Mark::sweepRad),
              part("bodyMm", REAL, Mark::bodyMm),
              Mark::new));

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL
          .messages(MARKS.instance(), MARKS.shape())
          .facts(Instance.APP.primitive(), SHAPE)
          .variables(Instance.APP.primitive(), LOCATION, TOWARD, WAY);
}
