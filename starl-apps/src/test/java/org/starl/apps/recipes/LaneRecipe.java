package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;

/** A recipe of docs/primitives.md. */
final class LaneRecipe extends LogicThread {

  private final MutexPrim mutex;

  LaneRecipe(GlobalVarHolder gvh) {
    super(gvh);
    mutex = new M_Mutex(gvh, "aisle", gvh.id.participants());
  }

  @Override
  public List<Object> callStarL() {
    boolean isInTheWest = gvh.id.name().toString().compareTo("bot3") < 0;
    String lane = isInTheWest ? "AISLE/east*2" : "AISLE/west"; // eastwards two robots at most
    mutex.do_mutex(List.of(lane));
    await(() -> mutex.crit().get() || mutex.failed().get());
    if (mutex.failed().get()) {
      return List.of(mutex.failure().get());
    }
    sleep(2_000); // through the aisle, perhaps behind others, against none
    mutex.release(lane);
    return List.of("through");
  }
}
