package org.starl.apps.hello.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;

/** Drives to a point one metre right of where the robot started, and returns how that ended. */
public final class Hello extends LogicThread {

  public Hello(GlobalVarHolder gvh) {
    super(gvh);
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    var start = gvh.gps.pose();
    gvh.plat.moat.doMove(new ItemPosition("goal", start.xMm() + 1000, start.yMm()));
    while (gvh.plat.moat.inMotion()) {
      sleep(100);
    }
    return List.of(gvh.plat.moat.motionflag().get());
  }
}
