package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;

/** A recipe of docs/primitives.md. */
final class TubesRecipe extends LogicThread {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 5_000, 3_000);

  private final DistributedPathPlanning paths;

  TubesRecipe(GlobalVarHolder gvh) {
    super(gvh);
    paths = new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
  }

  @Override
  public List<Object> callStarL() {
    ItemPosition goal = gvh.gps.getWaypointPosition("goal of " + gvh.id.name());
    if (goal == null) {
      return List.of("no goal");
    }
    await(gvh.gps::hasFix);
    paths.goTo(goal);
    await(() -> !paths.isUnderWay());
    return List.of(paths.tubeflag().get(), paths.failure().get());
  }
}
