package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;

/** A recipe of docs/primitives.md. */
final class BarrierRecipe extends LogicThread {

  private final Barrier barrier;

  BarrierRecipe(GlobalVarHolder gvh) {
    super(gvh);
    barrier = new Barrier(gvh, "phases");
  }

  @Override
  public List<Object> callStarL() {
    for (int phase = 1; phase <= 3; phase++) {
      sleep(gvh.plat.entropy.fork("work" + phase).nextLong(0, 2_000)); // the phase's work
      barrier.arrive();
      await(() -> barrier.outcome().get().isTold());
      if (!(barrier.outcome().get() instanceof BarrierOutcome.Passed)) {
        return List.of(barrier.outcome().get());
      }
    }
    return List.of("three phases");
  }
}
