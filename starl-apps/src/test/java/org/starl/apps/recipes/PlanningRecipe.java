package org.starl.apps.recipes;

import java.util.List;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/** A recipe of docs/primitives.md. */
final class PlanningRecipe extends LogicThread {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 5_000, 3_000);
  private static final double CLEARANCE_MM = 200; // covers the deviation from the path

  PlanningRecipe(GlobalVarHolder gvh) {
    super(gvh);
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    PlanTask task = PlanTask.of(gvh, new Point(4_500, 1_500), FLOOR, CLEARANCE_MM);
    Computation<Plan> plan = gvh.plat.compute(() -> new OptimalPlanner().plan(task));
    await(plan::isDone);
    if (!(plan.result() instanceof Plan.Found found)) {
      return List.of(plan.result()); // NoPath, or Blocked
    }
    for (Point corner : found.path().points()) {
      gvh.plat.moat.doMove(new ItemPosition("corner", corner.xMm(), corner.yMm()));
      await(() -> !gvh.plat.moat.inMotion());
    }
    return List.of(found.path().legs(), gvh.plat.moat.motionflag().get());
  }
}
