package org.starl.sim;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** Two robots that start on the floor, and the distance between their centres. */
record StartPair(RobotId one, RobotId other, double mm) {

  /** The two that start nearest to each other; null if fewer than two start on the floor. */
  static @Nullable StartPair nearest(List<RobotSpec> robots) {
    List<RobotSpec> byX = new ArrayList<>(robots);
    byX.removeIf(robot -> !robot.onFloor());
    byX.sort(Comparator.comparingDouble(robot -> robot.start().xMm()));
    StartPair nearest = null;
    double leastMm = Double.POSITIVE_INFINITY;
    for (int i = 0; i < byX.size(); i++) {
      Point at = byX.get(i).start().at();
      for (int j = i + 1; j < byX.size(); j++) {
        Point there = byX.get(j).start().at();
        if (there.xMm() - at.xMm() >= leastMm) {
          break;
        }
        double mm = at.distanceMm(there);
        if (mm < leastMm) {
          leastMm = mm;
          nearest = new StartPair(byX.get(i).id(), byX.get(j).id(), mm);
        }
      }
    }
    return nearest;
  }

  @Override
  public String toString() {
    boolean isInOrder = one.compareTo(other) <= 0;
    return "%s and %s start %.0f mm apart"
        .formatted(isInOrder ? one : other, isInOrder ? other : one, mm);
  }
}
