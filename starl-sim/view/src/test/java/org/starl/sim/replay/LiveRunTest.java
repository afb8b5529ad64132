package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.Simulation;
import org.starl.sim.TraceRecorder;
import org.starl.sim.record.Layer;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Intervention;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

class LiveRunTest {

  private static final long NS_PER_MS = 1_000_000;
  private static final RobotId BOT_1 = new RobotId("bot1");

  /** An intervention at a time that the recording has reached. */
  private record UserAction(int atMs, String what) {
    CompletableFuture<Long> to(LiveRun run) {
      if (what.startsWith("point ")) {
        String[] xy = what.substring("point ".length()).split(",", -1);
        return run.point(BOT_1, Integer.parseInt(xy[0]), Integer.parseInt(xy[1]));
      }
      return run.fault(what);
    }
  }

  private static String plain(Simulation.Builder simulation) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(out)) {
      simulation.observer(recorder).build().run();
    }
    return out.toString(StandardCharsets.UTF_8);
  }

  private static Recording recording() {
    return new Recording(Obstacles.NONE, Layer.NONE);
  }

  /** The trace of a live run with {@code actions}, which are sorted by time. */
  private static String live(Simulation.Builder simulation, List<UserAction> actions)
      throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Recording recording = recording();
    try (TraceRecorder recorder = new TraceRecorder(out);
        LiveRun run = new LiveRun(simulation.observer(recorder), recording)) {
      List<CompletableFuture<Long>> done = new ArrayList<>();
      run.start();
      for (UserAction action : actions) {
        goTo(action.atMs(), run, recording);
        if (!run.isOver()) {
          done.add(action.to(run));
        }
      }
      run.runUntil(Long.MAX_VALUE);
      for (CompletableFuture<Long> each : done) {
        each.get();
      }
      // close() would end the run early.
      while (!run.isOver()) {
        Thread.onSpinWait();
      }
      assertThat(run.failure()).isNull();
    }
    return out.toString(StandardCharsets.UTF_8);
  }

  /** Waits until the run has reached a time, or is over. */
  private static void goTo(long atMs, LiveRun run, Recording recording) {
    run.runUntil(atMs * NS_PER_MS);
    while (recording.endNs() < atMs * NS_PER_MS && !run.isOver()) {
      Thread.onSpinWait();
    }
  }

  private static List<Intervention> interventions(String trace) throws Exception {
    List<Intervention> found = new ArrayList<>();
    try (var reader =
        new TraceReader(
            "live",
            new ByteArrayInputStream(trace.getBytes(StandardCharsets.UTF_8)),
            Vocabulary.NONE)) {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        if (event instanceof Intervention intervention) {
          found.add(intervention);
        }
      }
    }
    return found;
  }

  private static String again(long seed, String trace) throws Exception {
    return plain(
        Wander.simulation(seed).stepListener(new InterventionReplayer(interventions(trace))));
  }

  @Test
  @Timeout(60)
  void aRecordingDoesNotChangeTheTrace() throws Exception {
    assertThat(live(Wander.simulation(4), List.of())).isEqualTo(plain(Wander.simulation(4)));
  }

  @Provide
  Arbitrary<UserAction> actions() {
    Arbitrary<String> what =
        Arbitraries.of(
            "crash(bot1,restart=2s)",
            "crash(bot2)",
            "stuck(bot0,for=3s)",
            "drift(bot2,20000ppm,for=4s)",
            "compute(bot2,30ms,for=2s)",
            "loss(0.5,for=3s)",
            "jump(bot1,500mm,for=1s)",
            "block(bot0,for=2s)",
            "noise(half,80mm)",
            "point 100,200",
            "point 3500,-700");
    return Combinators.combine(Arbitraries.integers().between(0, 28_000), what).as(UserAction::new);
  }

  @Property(tries = 25)
  void aRunWithInterventionsReplaysToTheSameBytes(
      @ForAll @IntRange(max = 1000) int seed, @ForAll("plans") List<UserAction> actions)
      throws Exception {
    String trace = live(Wander.simulation(seed), actions);
    assertThat(interventions(trace)).hasSizeBetween(1, actions.size());
    assertThat(again(seed, trace)).as("seed %d, %s", seed, actions).isEqualTo(trace);
  }

  @Provide
  Arbitrary<List<UserAction>> plans() {
    return actions()
        .list()
        .ofMinSize(1)
        .ofMaxSize(6)
        .map(list -> list.stream().sorted(Comparator.comparingInt(UserAction::atMs)).toList());
  }

  @Test
  @Timeout(60)
  void anInterventionThatEndsTheRunWithAnErrorIsAnswered() {
    SimObserver broken =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (event instanceof Intervention) {
              throw new IllegalStateException("broken");
            }
          }
        };
    try (LiveRun run = new LiveRun(Wander.simulation(1).observer(broken), recording())) {
      run.start();
      assertThat(run.fault("loss(0.5)")).failsWithin(30, TimeUnit.SECONDS);
    }
  }

  @Test
  @Timeout(60)
  void theRunWaitsAtItsLimitAndInterventionsHappenThere() throws Exception {
    Recording recording = recording();
    try (LiveRun run = new LiveRun(Wander.simulation(1), recording)) {
      run.start();
      run.runUntil(2_000 * NS_PER_MS);
      long atNs = run.point(BOT_1, 1, 2).get();
      assertThat(atNs).isBetween(0L, 2_200 * NS_PER_MS);
      long laterNs = run.fault("stuck(bot1)").get();
      assertThat(laterNs).isBetween(atNs, 2_200 * NS_PER_MS);
      assertThat(recording.endNs()).isLessThan(2_200 * NS_PER_MS);
      assertThat(recording.isOver()).isFalse();
    }
    assertThat(recording.isOver()).isTrue();
    assertThat(recording.endNs()).isLessThan(2_200 * NS_PER_MS);
    assertThat(recording.marks())
        .extracting(Mark::kind)
        .containsExactly(
            Mark.Kind.INTERVENTION,
            Mark.Kind.INTERVENTION,
            Mark.Kind.FAULT,
            Mark.Kind.INTERVENTION);
  }

  @Test
  @Timeout(60)
  void aStoppedRunReplaysToTheSameEnd() throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TraceRecorder recorder = new TraceRecorder(out);
    LiveRun run = new LiveRun(Wander.simulation(6).observer(recorder), recording());
    run.start();
    run.runUntil(4_000 * NS_PER_MS);
    run.point(BOT_1, 0, 0).get();
    run.close();
    recorder.close();
    String trace = out.toString(StandardCharsets.UTF_8);
    assertThat(trace).contains("\"name\":\"stop\"").contains("\"kind\":\"end\"");
    assertThat(again(6, trace)).isEqualTo(trace);
  }

  @Test
  @Timeout(60)
  void aRobotDrivesToThePointThatIsSent() throws Exception {
    String trace = live(Wander.simulation(2), List.of(new UserAction(3_000, "point 1234,2345")));
    assertThat(trace.lines().filter(line -> line.contains("\"xMm\":1234.0,\"yMm\":2345.0")))
        .isNotEmpty()
        .allMatch(line -> line.contains("\"robot\":\"bot1\""));
  }

  @Test
  @Timeout(60)
  void invalidInterventionsAreRefusedAndNotTraced() throws Exception {
    String plain = plain(Wander.simulation(3));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TraceRecorder recorder = new TraceRecorder(out);
    Recording recording = recording();
    LiveRun run = new LiveRun(Wander.simulation(3).observer(recorder), recording);
    run.start();
    goTo(5_000, run, recording);
    assertThatThrownBy(() -> run.fault("crush(bot1)")).isInstanceOf(BadInput.class);
    assertThatThrownBy(run.fault("crash(bot7)")::get)
        .isInstanceOf(ExecutionException.class)
        .hasMessageContaining("no robot is called bot7");
    assertThatThrownBy(run.point(new RobotId("bot8"), 1, 1)::get)
        .hasMessageContaining("no robot is called bot8");
    assertThatThrownBy(run.fault("stuck(bot1,until=1ms)")::get)
        .hasMessageContaining("expected a later end");
    run.runUntil(Long.MAX_VALUE);
    while (!run.isOver()) {
      Thread.onSpinWait();
    }
    run.close();
    recorder.close();
    assertThat(out.toString(StandardCharsets.UTF_8)).isEqualTo(plain);
    assertThatThrownBy(run.fault("crash(bot1)")::get).hasMessageContaining("the run has ended");
  }

  @Test
  @Timeout(60)
  void noThreadIsLeftBehind() throws Exception {
    for (int i = 0; i < 5; i++) {
      LiveRun run = new LiveRun(Wander.simulation(i), recording());
      run.start();
      run.runUntil(1_000 * NS_PER_MS);
      run.close();
    }
    Thread[] threads = new Thread[Thread.activeCount() + 16];
    int count = Thread.enumerate(threads);
    assertThat(IntStream.range(0, count).mapToObj(i -> threads[i].getName()))
        .doesNotContain("simulation");
  }
}
