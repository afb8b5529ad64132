package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierOutcome.Excluded;
import org.starl.primitives.barrier.BarrierOutcome.Failed;
import org.starl.primitives.registration.Registration;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.sim.TraceRecorder;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.Unsynced;

/** Barriers on simulated robots, through their gvh. */
class BarrierSimTest {

  private static final long S = 1_000_000_000;
  private static final int GENERATIONS = 8;
  private static final BarrierSettings SETTINGS = BarrierSettings.DEFAULT.withDeadlineMs(20_000);

  /** Works for up to three seconds, meets the others, and again; returns what it was told. */
  private static final class Worker extends LogicThread {
    private final Barrier barrier;

    Worker(GlobalVarHolder gvh) {
      super(gvh);
      barrier = new Barrier(gvh, "works", gvh.id.participants(), SETTINGS);
    }

    @Override
    public List<Object> callStarL() {
      List<Object> told = new ArrayList<>();
      for (int i = 0; i < GENERATIONS; i++) {
        sleep(gvh.plat.entropy.fork("work" + i).nextLong(0, 3_000));
        barrier.arrive();
        await(() -> barrier.outcome().get().isTold());
        told.add(barrier.outcome().get());
      }
      // Stays for the others: some may not know the outcome yet.
      sleep(5_000);
      return told;
    }
  }

  /** Registers, and when all are there, meets them once. */
  private static final class Guest extends LogicThread {
    private final Registration registration;

    Guest(GlobalVarHolder gvh) {
      super(gvh);
      registration = new Registration(gvh, "inn");
    }

    @Override
    public List<Object> callStarL() {
      registration.do_register();
      await(() -> registration.view().ids().size() == gvh.id.participants().size());
      Barrier barrier = new Barrier(gvh, "dinner", registration, SETTINGS);
      barrier.arrive();
      await(() -> barrier.outcome().get().isTold());
      sleep(5_000);
      return List.of(barrier.source().name(), barrier.outcome().get().toString());
    }
  }

  private static Simulation.Builder builder(long seed) {
    return Simulation.builder()
        .name("barrier")
        .seed(seed)
        .settings(
            SimSettings.builder()
                .set("messageLoss", "0.2")
                .set("messageDelay", "uniform(10ms,100ms)")
                .set("duration", "300s")
                .build())
        .monitor(() -> new BarrierSpec(15 * S, 40 * S))
        .monitor(BarrierConformance::new);
  }

  private static Simulation.Builder workers(long seed) {
    return builder(seed).robots(5, Worker::new);
  }

  @Property(tries = 15)
  void robotsMeetRepeatedlyUnderLoss(@ForAll long seed) {
    SimResult result = workers(seed).build().run();
    assertThat(result.isFinished()).as("unfinished: %s", result.unfinished()).isTrue();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.spec().checks(BarrierSpec.NO_EARLY)).isEqualTo(5 * GENERATIONS);
    assertThat(result.spec().checks(BarrierSpec.NOT_HUNG)).isEqualTo(5 * GENERATIONS);
  }

  @Property(tries = 15)
  void crashedMembersAreReportedMissingAndExcludedWhenTheyReturn(@ForAll long seed) {
    SimResult result = workers(seed).director(BarrierSimTest::crashTwo).build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    for (int i = 0; i < 3; i++) {
      List<Object> told = result.results().get(new RobotId("bot" + i));
      assertThat(told).hasSize(GENERATIONS).noneMatch(Excluded.class::isInstance);
      assertThat(told.stream().filter(Failed.class::isInstance).map(f -> (Failed) f))
          .flatExtracting(Failed::missing)
          .extracting(id -> id.robot().name())
          .containsExactlyInAnyOrder("bot3", "bot4");
    }
    assertThat(result.results().get(new RobotId("bot3")))
        .isNotEmpty()
        .allMatch(new Excluded(0)::equals);
  }

  private static void crashTwo(SimControl control) {
    control.at(4 * S, () -> control.crash(new RobotId("bot4")));
    control.at(6 * S, () -> control.crash(new RobotId("bot3"), 3 * S, Unsynced.LOST));
  }

  @Test
  void robotsOfOneViewMeet() {
    SimResult result = builder(3).robots(4, Guest::new).build().run();
    assertThat(result.isFinished()).as("unfinished: %s", result.unfinished()).isTrue();
    assertThat(result.results().values().stream().distinct()).hasSize(1);
    assertThat(result.results().values().iterator().next().get(1)).isEqualTo("1:passed");
  }

  @Test
  void aSecondBarrierOfOneInstanceThrows() {
    Simulation simulation =
        builder(1)
            .robots(
                1,
                gvh -> {
                  new Barrier(gvh, "works").close();
                  return new Worker(gvh);
                })
            .build();
    assertThatThrownBy(simulation::run)
        .isInstanceOf(SimulationFailed.class)
        .hasStackTraceContaining("barrier/works: this robot has this instance already");
  }

  @Test
  void equalSeedsGiveEqualTracesOnBothCarriers() {
    String trace = trace(workers(7).carriers(CarrierKind.PLATFORM));
    assertThat(trace)
        .contains("arrive")
        .contains("outcome")
        .contains("\"Passed\":{\"generation\":8}");
    assertThat(trace(workers(7).carriers(CarrierKind.best()))).isEqualTo(trace);
    assertThat(trace(workers(8).carriers(CarrierKind.best()))).isNotEqualTo(trace);
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
