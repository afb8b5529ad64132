package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.TraceRecorder;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.Unsynced;

/** Elections on simulated robots, through their gvh. */
class ElectionSimTest {

  private static final long S = 1_000_000_000;
  private static final long RUN_MS = 60_000;

  /** Is a candidate for a minute, again after each fail; returns its last leader. */
  private static final class Delegate extends LogicThread {
    private final Election election;

    Delegate(GlobalVarHolder gvh) {
      super(gvh);
      election =
          new Election(
              gvh,
              "convoy",
              gvh.id.participants(),
              ElectionSettings.DEFAULT.withStrategy(ElectionStrategy.BULLY).withDeadlineMs(10_000));
    }

    @Override
    public List<Object> callStarL() {
      sleep(gvh.plat.entropy.fork("delegate").nextLong(0, 2_000));
      long endNs = RUN_MS * 1_000_000;
      while (gvh.plat.clock.nowNs() < endNs) {
        election.do_election();
        await(() -> election.failed().get(), (endNs - gvh.plat.clock.nowNs()) / 1_000_000 + 1);
      }
      return List.of(election.Leader().get(), election.isLeader(), election.me());
    }
  }

  /** One crashes for good, and later one that comes back. */
  private static void crashTwo(SimControl control) {
    control.at(20 * S, () -> control.crash(new RobotId("bot4")));
    control.at(35 * S, () -> control.crash(new RobotId("bot3"), 3 * S, Unsynced.LOST));
  }

  private static Simulation.Builder delegates(long seed) {
    return Simulation.builder()
        .name("delegates")
        .seed(seed)
        .robots(5, Delegate::new)
        .director(ElectionSimTest::crashTwo)
        .settings(
            SimSettings.builder()
                .set("messageLoss", "0.2")
                .set("messageDelay", "uniform(10ms,100ms)")
                .set("duration", "120s")
                .build())
        .monitor(() -> new ElectionSpec(12 * S, 10 * S))
        .monitor(ElectionConformance::new);
  }

  @Property(tries = 15)
  void leadersAreElectedAndReplacedAfterCrashesUnderLoss(@ForAll long seed) {
    SimResult result = delegates(seed).build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.spec().checks(ElectionSpec.ELECTED)).isPositive();
    assertThat(result.results()).hasSize(4);
    assertThat(result.results().values().stream().map(ended -> ended.get(0)).distinct()).hasSize(1);
    assertThat(result.results().values())
        .allSatisfy(ended -> assertThat(((Leader) ended.get(0)).isElected()).isTrue())
        .allSatisfy(ended -> {
          boolean isNamed = ((Leader.Name) ended.get(0)).id().equals(ended.get(2));
          assertThat(ended.get(1)).isEqualTo(isNamed);
        });
  }

  @Test
  void equalSeedsGiveEqualTracesOnBothCarriers() {
    String trace = trace(delegates(7).carriers(CarrierKind.PLATFORM));
    assertThat(trace).contains("do_election").contains("candidate").contains("Leader");
    assertThat(trace(delegates(7).carriers(CarrierKind.best()))).isEqualTo(trace);
    assertThat(trace(delegates(8).carriers(CarrierKind.best()))).isNotEqualTo(trace);
  }

  private static String trace(Simulation.Builder builder) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(bytes)) {
      builder.observer(recorder).build().run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
