package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Persistent;
import org.starl.shape.Shapes;
import org.starl.sim.Simulation;

/** A persistent variable in the simulator is lost and kept as a disc's. */
class PersistentCrashTest {

  /** Counts its starts. */
  private static final class Counting extends LogicThread {
    private final Persistent<Integer> starts;

    Counting(GlobalVarHolder gvh) {
      super(gvh);
      starts = gvh.plat.persistent("starts", Shapes.INT, 0);
    }

    @Override
    public List<Object> callStarL() {
      sleep(1_000);
      starts.set(starts.get() + 1);
      sleep(10_000);
      return List.of(gvh.id.boot(), starts.get());
    }
  }

  @ParameterizedTest
  @CsvSource({"10ms, '[2, 2]'", "900ms, '[2, 1]'"})
  void aRestartReadsWhatWasFlushed(String flush, String told) {
    String results =
        Simulation.builder()
            .robots(1, Counting::new)
            .fault("disk(bot0," + flush + ",at=0s,until=60s)")
            .fault("crash(bot0,at=1500ms,restart=3s,lose=unsynced)")
            .build()
            .run()
            .results()
            .toString();
    assertThat(results).contains(told);
  }
}
