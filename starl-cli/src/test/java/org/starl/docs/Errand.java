package org.starl.docs;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;

/** Stands still until it is sent somewhere, and drives there. */
public final class Errand extends LogicThread {

  public Errand(GlobalVarHolder gvh) {
    super(gvh);
  }

  @Override
  public List<Object> callStarL() {
    while (true) {
      sleep(1000);
    }
  }

  @Override
  public void receivedPointInput(int xMm, int yMm) {
    gvh.plat.moat.doMove(new ItemPosition("sent", xMm, yMm));
  }
}
