package org.starl.apps.recipes;

import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.monitor.AppMonitor;

/** Every robot has made its rounds within a bound, and is at home when it has made one. */
final class PatrolSpec extends AppMonitor {

  private static final double NEAR_MM = 100;

  private final Map<RobotId, Point> homes;
  private final int rounds;
  private final long boundNs;
  private final TreeSet<RobotId> underWay;

  PatrolSpec(Map<RobotId, Point> homes, int rounds, long boundNs) {
    this.homes = homes;
    this.rounds = rounds;
    this.boundNs = boundNs;
    underWay = new TreeSet<>(homes.keySet());
    lemma("at_home", "A robot that counts a round is at home.");
    lemma("home_in_time", "Each robot has made all its rounds within the bound.");
    on(PatrolApp.ROUNDS, this::onRounds);
  }

  private void onRounds(RobotId robot, int made) {
    if (made == 0) {
      return;
    }
    double mm = bodies().poseAt(robot, nowNs()).at().distanceMm(homes.get(robot));
    check("at_home", mm <= NEAR_MM, List.of(robot), Math.round(mm) + " mm from home");
    if (made == rounds) {
      underWay.remove(robot);
      check("home_in_time", nowNs() <= boundNs, List.of(robot), "too late");
    }
  }

  @Override
  protected void onEnd() {
    check("home_in_time", underWay.isEmpty(), underWay, "not all rounds made");
  }
}
