package org.starl.apps.race;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.apps.race.logic.RacePoint;
import org.starl.body.MotionParameters;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/** The points of a race: the {@code WAY} lines of a file in their order, or drawn. */
final class RacePoints {

  /** A claim has two bytes for the point's number. */
  private static final int MAX = 1000;

  private static final int TRIES = 100;

  private RacePoints() {}

  /**
   * @throws BadInput if the file cannot be read or its points cannot be raced to
   */
  static List<RacePoint> read(String file) {
    List<RacePoint> points = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (Waypoint waypoint : WaypointFiles.read(Path.of(file)).waypoints()) {
      double radiusMm = waypoint.radiusMm().orElse(MotionParameters.DEFAULT.goalRadiusMm());
      String quoted = BadInput.quote(waypoint.name());
      if (!names.add(waypoint.name())) {
        throw new BadInput(
            file + ": two points are called " + quoted + ": expected different names");
      }
      if (!(radiusMm > 0)) {
        throw new BadInput(file + ": point " + quoted + ": expected a radius above 0");
      }
      points.add(
          new RacePoint(waypoint.name(), new Point(waypoint.xMm(), waypoint.yMm()), radiusMm));
    }
    if (points.isEmpty() || points.size() > MAX) {
      throw new BadInput(
          file + ": has " + points.size() + " points: expected 1 to " + MAX + " WAY lines");
    }
    return points;
  }

  /**
   * Random points on the floor, each, if there is room, a quarter of its width from the one before.
   */
  static List<RacePoint> drawn(int count, SimSettings settings, Rng rng) {
    double widthMm = settings.get(Setting.FLOOR_WIDTH);
    double heightMm = settings.get(Setting.FLOOR_HEIGHT);
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
