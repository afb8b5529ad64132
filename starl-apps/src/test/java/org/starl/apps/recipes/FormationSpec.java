package org.starl.apps.recipes;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.monitor.AppMonitor;

/** No robot drives before all know the formation; at the end each is at its place in it. */
final class FormationSpec extends AppMonitor {

  private static final double NEAR_MM = 100;

  private final List<RobotId> team;
  private final Map<RobotId, String> known = new TreeMap<>();

  FormationSpec(List<RobotId> team) {
    this.team = team;
    lemma("all_know", "No robot drives before all robots know the formation.");
    lemma("one_formation", "All robots know one formation.");
    lemma("in_place", "At the end of the run each robot is at its place in the formation.");
    on(FormationApp.FORMATION, this::onFormation);
    on(FormationApp.DRIVING, this::onDriving);
  }

  private void onFormation(RobotId robot, String formation) {
    if (!formation.isEmpty()) {
      known.put(robot, formation);
      boolean one = new TreeSet<>(known.values()).size() == 1;
      check("one_formation", one, known.keySet(), known.toString());
    }
  }

  private void onDriving(RobotId robot, boolean driving) {
    if (driving) {
      boolean all = known.size() == team.size();
      check("all_know", all, List.of(robot), "only " + known.keySet() + " know it");
    }
  }

  @Override
  protected void onEnd() {
    for (int i = 0; i < team.size(); i++) {
      RobotId robot = team.get(i);
      String formation = known.getOrDefault(robot, "line");
      Point place = FormationApp.place(formation, i).at();
      double mm = bodies().poseAt(robot, nowNs()).at().distanceMm(place);
      check("in_place", mm <= NEAR_MM, List.of(robot), Math.round(mm) + " mm from its place");
    }
  }
}
