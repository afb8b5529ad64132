package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Obstacles;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.Recording;

/** The viewer shows how a run ended. */
class EndingTest {

  private static final class App extends LogicThread {
    private final long untilMs;

    App(GlobalVarHolder gvh, long untilMs) {
      super(gvh);
      this.untilMs = untilMs;
    }

    @Override
    public List<Object> callStarL() {
      sleep(untilMs);
      return returnResults();
    }
  }

  private static String ending(long untilMs) {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    Simulation.builder()
        .robots(1, gvh -> new App(gvh, untilMs))
        .endNs(20 * Runs.SECOND_NS)
        .observer(recording)
        .build()
        .run();
    return FloorView.ending(recording);
  }

  @Test
  void theEndOfAnUnfinishedRunNamesTheLikelyCause() {
    assertThat(ending(60_000))
        .startsWith("The run ended at 20.000 s, not finished: ")
        .contains("bot0 waits at EndingTest.java:");
  }

  @Test
  void theEndOfAFinishedRunIsItsTime() {
    assertThat(ending(5_000)).isEqualTo("The run ended at 5.000 s");
  }
}
