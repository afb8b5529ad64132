package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.sim.Simulation;

/** A fault that ends while a robot's program is down is over when the program starts again. */
class FaultEndsDuringCrashTest {

  private static final long MS = 1_000_000;

  /** The first start waits for its crash; the second one measures a write and a second. */
  private static final class Writer extends LogicThread {
    private boolean isWritten;

    Writer(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      if (gvh.id.boot() == 1) {
        sleep(60_000);
      }
      long beganNs = gvh.plat.clock.nowNs();
      gvh.plat.stable.put("key", new byte[1], () -> isWritten = true);
      await(() -> isWritten);
      return List.of((gvh.plat.clock.nowNs() - beganNs) / MS);
    }
  }

  private static Object writeMs(String fault) {
    return Simulation.builder()
        .robots(1, Writer::new)
        .fault(fault)
        .fault("crash(bot0,at=2s,restart=3s)")
        .build()
        .run()
        .results()
        .values();
  }

  @Test
  void storageIsFastAgain() {
    assertThat(writeMs("disk(bot0,900ms,at=1s,until=4s)")).asString().isEqualTo("[[0]]");
  }

  @Test
  void storageIsSlowWhileTheFaultLasts() {
    assertThat(writeMs("disk(bot0,900ms,at=1s,until=9s)")).asString().isEqualTo("[[900]]");
  }
}
