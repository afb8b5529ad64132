package org.starl.apps.race.view;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.BinaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceApp.Location;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * Draws each point as a target, in its winner's colour once it is won, the course dashed, and
 * dotted lines from the robots to their points.
 */
public final class RaceLayer implements Layer {

  private static final String COURSE = "course";
  private static final String TARGETS = "targets";
  private static final String WAYS = "ways";
  private static final double TARGET_MM = 230;
  private static final int NAME_MM = 110;
  private static final int WINNER_MM = 85;

  private final List<RacePoint> points;
  private final SortedMap<Integer, Claim> winners = new TreeMap<>();

  public RaceLayer(List<RacePoint> points) {
    this.points = List.copyOf(points);
  }

  @Override
  public RaceLayer copy() {
    RaceLayer copy = new RaceLayer(points);
    copy.winners.putAll(winners);
    return copy;
  }

  @Override
  public void observe(TraceEvent event) {
    Claim claim = RaceFact.taken(event);
    if (claim != null) {
      winners.merge(claim.point(), claim, BinaryOperator.minBy(Comparator.naturalOrder()));
    }
  }

  @Override
  public List<String> parts() {
    return List.of(COURSE, TARGETS, WAYS);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (look.shows(COURSE)) {
      floor.setColor(look.theme().shade());
      floor.setStroke(look.dashes(14, 60));
      for (int i = 1; i < points.size(); i++) {
        floor.draw(Figures.line(points.get(i - 1).at(), points.get(i).at()));
      }
    }
    for (int i = 0; look.shows(TARGETS) && i < points.size(); i++) {
      target(floor, points.get(i), winners.get(i), scene, look);
    }
    for (RobotId robot : look.shows(WAYS) ? scene.robots() : List.<RobotId>of()) {
      way(floor, robot, scene, look);
    }
  }

  private static void target(
      Graphics2D floor, RacePoint point, @Nullable Claim won, Scene scene, Look look) {
    Color colour = won == null ? look.theme().muted() : look.robot(scene, won.winner());
    floor.setColor(Theme.faded(colour, 60));
    floor.fill(Figures.disc(point.at(), TARGET_MM));
    floor.setColor(colour);
    floor.setStroke(look.line(16));
    floor.draw(Figures.disc(point.at(), TARGET_MM));
    floor.fill(Figures.disc(point.at(), point.radiusMm()));
    int x = (int) (point.at().xMm() + TARGET_MM + 30);
    int y = (int) point.at().yMm();
    floor.setColor(look.theme().edge(colour));
    Figures.text(floor, point.name(), new Font(Font.SANS_SERIF, Font.BOLD, NAME_MM), x, y);
    if (won != null) {
      String winner = won.winner() + " " + Time.text(won.atNs(), 1);
      Font plain = new Font(Font.SANS_SERIF, Font.PLAIN, WINNER_MM);
      Figures.text(floor, winner, plain, x, y - NAME_MM);
    }
  }

  private void way(Graphics2D floor, RobotId robot, Scene scene, Look look) {
    String name = scene.variable(robot, Instance.APP, RaceFact.POINT);
    for (RacePoint point : points) {
      if (point.name().equals(name) && scene.pose(robot).isPresent()) {
        floor.setColor(look.robot(scene, robot));
        floor.setStroke(look.dots(16, 45));
        floor.draw(Figures.line(scene.pose(robot).get().at(), point.at()));
      }
    }
  }

  /** Around the targets, with room for the names of their winners to the right. */
  @Override
  public SortedMap<String, Rectangle> areas() {
    SortedMap<String, Rectangle> areas = new TreeMap<>();
    for (RacePoint point : points) {
      double sideMm = 2 * point.radiusMm();
      areas.put(point.name(), Rectangle.around(point.at(), sideMm, sideMm));
    }
    return areas;
  }

  @Override
  public List<Point> corners() {
    return points.stream()
        .flatMap(point ->
            Stream.of(
                point.at().plus(new Point(-TARGET_MM, -TARGET_MM)),
                point.at().plus(new Point(4 * TARGET_MM, TARGET_MM))))
        .toList();
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    String won =
        winners.values().stream()
            .filter(claim -> claim.winner().equals(robot))
            .map(claim -> points.get(claim.point()).name())
            .collect(Collectors.joining(" "));
    return activity(robot, scene) + (won.isEmpty() ? "" : ", has won " + won);
  }

  private static String activity(RobotId robot, Scene scene) {
    Location location = scene.variable(robot, Instance.APP, RaceFact.LOCATION);
    String point = scene.variable(robot, Instance.APP, RaceFact.POINT);
    if (location == null) {
      return "";
    }
    return switch (location) {
      case START -> "waits for its position";
      case PICK, RACE -> "races to " + point;
      case MAKE_WAY -> "makes way to " + point;
      case TELL -> "announces the winners";
      case DONE -> "has finished";
    };
  }

  /** Most is to be seen when some points are won, others not, and trails are long. */
  @Override
  public double interest(Scene scene) {
    boolean isOn = winners.size() < points.size();
    return winners.size() + (isOn ? points.size() : 0) + Time.seconds(scene.nowNs()) / 1e4;
  }
}
