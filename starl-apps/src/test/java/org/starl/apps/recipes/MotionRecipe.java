package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionControl;
import org.starl.primitives.motion.MotionPrim;

/** A recipe of docs/primitives.md. */
final class MotionRecipe extends LogicThread {

  private final MotionPrim mc;

  MotionRecipe(GlobalVarHolder gvh) {
    super(gvh);
    mc = new MotionControl(gvh);
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    Pose start = gvh.gps.pose();
    ItemPosition goal = new ItemPosition("goal", start.xMm() + 1_000, start.yMm());
    Circle pit = new Circle(new Point(start.xMm() + 500, start.yMm()), 100);
    mc.do_move(goal, pit);
    await(() -> mc.motionflag().get() != MotionFlag.MOVING);
    return List.of(mc.motionflag().get(), mc.failure());
  }
}
