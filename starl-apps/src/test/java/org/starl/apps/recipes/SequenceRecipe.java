package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.PipelinePrim;

/** A recipe of docs/primitives.md. */
final class SequenceRecipe extends LogicThread {

  private final PipelinePrim mutex;

  SequenceRecipe(GlobalVarHolder gvh) {
    super(gvh);
    mutex = new M_Mutex(gvh, "dock", gvh.id.participants());
  }

  @Override
  public List<Object> callStarL() {
    List<String> way = List.of("RAMP", "DOCK");
    mutex.doSequence(way);
    while (!mutex.held().contains("RAMP")) {
      sleep(100);
      if (mutex.failed().get()) {
        mutex.doSequence(way); // it holds nothing yet: it asks again
      }
    }
    sleep(1_000); // it drives on the ramp, and stops before the dock
    await(() -> mutex.held().contains("DOCK"));
    sleep(1_000); // into the dock, until its body has left the ramp
    mutex.release("RAMP"); // the next robot drives on
    sleep(1_000);
    mutex.release("DOCK");
    return List.of("used");
  }
}
