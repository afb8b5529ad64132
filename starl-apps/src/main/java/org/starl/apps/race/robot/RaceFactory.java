package org.starl.apps.race.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.race.logic.RaceApp;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.body.MotionParameters;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.random.Rng;
import org.starl.trace.Vocabulary;

/** The paper's race, to points drawn from the seed. */
public final class RaceFactory implements AppFactory {

  public static final Parameter POINTS =
      new Parameter(
          "points",
          "",
          "a .wpt file: its WAY lines are the points, in order; empty: drawn from the seed");
  public static final Parameter DRAWN =
      new Parameter("drawn", "5", "number of points drawn from the seed", Form.whole(1, 100));
  public static final Parameter BOXES =
      new Parameter(
          "boxes",
          "0",
          "number of points, the first ones, on which a box stands",
          Form.whole(0, 100));

  private static final String XID = "race";
  private static final int MAX_ROBOTS = 1000;
  private static final int TRIES = 100;

  /** The simulator's default floor. */
  private static final double WIDTH_MM = 5000;

  private static final double HEIGHT_MM = 3000;

  /** More robots than this get a larger floor. */
  private static final int ROBOTS_ON_DEFAULT_FLOOR = 12;

  @Override
  public String name() {
    return "race";
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return RaceFact.VOCABULARY;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(POINTS, DRAWN, BOXES);
  }

  @Override
  public RobotProgram program(Request request) {
    request.refuseOnRobots(POINTS);
    request.refuseOnRobots(BOXES);
    checkRobots(request.robots().orElse(1));
    double scale = floorScale(request);
    return program(drawn(request, Math.ceil(scale * WIDTH_MM), Math.ceil(scale * HEIGHT_MM)));
  }

  /** A race to these points. */
  public static RobotProgram program(List<RacePoint> points) {
    return RobotProgram.of(gvh -> new RaceApp(gvh, XID, points));
  }

  /**
   * @throws BadInput if a race has not so many robots
   */
  public static void checkRobots(int robots) {
    if (robots < 1 || robots > MAX_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MAX_ROBOTS + " in a race");
    }
  }

  /** By how much the floor of a race is longer and wider than the default floor. */
  public static double floorScale(Request request) {
    return StrictMath.sqrt(
        Math.max(1, request.robots().orElse(1) / (double) ROBOTS_ON_DEFAULT_FLOOR));
  }

  /** The points that a request draws, on a floor of this size. */
  public static List<RacePoint> drawn(Request request, double widthMm, double heightMm) {
    return drawn(request.whole(DRAWN), widthMm, heightMm, new Rng(request.seed()).fork("race"));
  }

  /**
   * Random points on the floor, each, if there is room, a quarter of its width from the one before.
   */
  public static List<RacePoint> drawn(int count, double widthMm, double heightMm, Rng rng) {
    List<RacePoint> points = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Point at = new Point(widthMm * rng.nextDouble(), heightMm * rng.nextDouble());
      for (int tries = 0;
          tries < TRIES && i > 0 && at.distanceMm(points.get(i - 1).at()) < widthMm / 4;
          tries++) {
        at = new Point(widthMm * rng.nextDouble(), heightMm * rng.nextDouble());
      }
      points.add(new RacePoint(name(i), at, MotionParameters.DEFAULT.goalRadiusMm()));
    }
    return points;
  }

  /** A, B, ... Z, A1, B1, ... */
  private static String name(int i) {
    String letter = String.valueOf((char) ('A' + i % 26));
    return i < 26 ? letter : letter + i / 26;
  }
}
