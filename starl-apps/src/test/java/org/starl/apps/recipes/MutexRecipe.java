package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;

/** A recipe of docs/primitives.md. */
final class MutexRecipe extends LogicThread {

  private final MutexPrim mutex;

  MutexRecipe(GlobalVarHolder gvh) {
    super(gvh);
    mutex = new M_Mutex(gvh, "dock", gvh.id.participants()); // a fixed group
  }

  @Override
  public List<Object> callStarL() {
    mutex.do_mutex(List.of("DOCK", "RAMP"));
    await(() -> mutex.crit().get() || mutex.failed().get());
    if (mutex.failed().get()) {
      return List.of(mutex.failure().get());
    }
    sleep(1_000); // this robot alone uses both
    mutex.release("RAMP");
    sleep(1_000);
    mutex.release("DOCK");
    return List.of("used");
  }
}
