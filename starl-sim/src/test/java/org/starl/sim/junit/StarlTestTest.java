package org.starl.sim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.engine.discovery.MethodSelector;
import org.junit.platform.testkit.engine.EngineExecutionResults;
import org.junit.platform.testkit.engine.EngineTestKit;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceReader;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** {@link StarlTest}, as JUnit's own test kit sees it. */
class StarlTestTest {

  private static final String FIXTURE = "starl.fixture";
  private static final Pattern SEED = Pattern.compile("-Dstarl\\.seed=(-?\\d+)");

  /** Hides the fixtures below, some of which fail, from test discovery. */
  static final class OnlyFromHere implements ExecutionCondition {
    @Override
    public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
      return context.getConfigurationParameter(FIXTURE).isPresent()
          ? ConditionEvaluationResult.enabled("asked for")
          : ConditionEvaluationResult.disabled("run by StarlTestTest alone");
    }
  }

  /** bot1 sends a word to bot0, which takes it as an error if none has come after 50 ms. */
  private static final class Impatient extends LogicThread {
    private static final Channel<Boolean> WORDS =
        new Channel<>(
            "test",
            "words",
            new Codec<>() {
              @Override
              public void write(Boolean word, WireWriter out) {
                out.u8(1);
              }

              @Override
              public Boolean read(WireReader in) {
                return in.u8() == 1;
              }
            });

    private boolean isHeard;

    Impatient(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Boolean> words = gvh.comms.open(WORDS, (from, word) -> isHeard = word);
      boolean isSender = gvh.id.name().name().equals("bot1");
      sleep(100);
      if (isSender) {
        words.send(new RobotId("bot0"), true);
      }
      sleep(50);
      if (!isSender && !isHeard) {
        throw new IllegalStateException("heard nothing");
      }
      return List.of();
    }
  }

  private static final Var<Integer> COUNT = Var.of("count", Shapes.INT);

  /** Counts to three, a wait each time; some seeds make it stumble. */
  private static final class Counter extends LogicThread {
    private final boolean stumbles;

    Counter(GlobalVarHolder gvh, boolean stumbles) {
      super(gvh);
      this.stumbles = stumbles;
    }

    @Override
    public List<Object> callStarL() {
      GvhCell<Integer> count = gvh.variable(COUNT, 0);
      for (int i = 0; i < 3; i++) {
        sleep(100);
        count.set(stumbles && i == 2 ? 7 : i);
      }
      return List.of("counted");
    }
  }

  private static boolean isSeven(TraceEvent.Variable variable) {
    return Integer.valueOf(7).equals(variable.of(COUNT));
  }

  /** The count is never above 2. */
  private static final class CountsToThree implements Monitor {
    @Override
    public List<String> lemmas() {
      return List.of("counts_to_three");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof TraceEvent.Variable count && isSeven(count)) {
        report.violated("counts_to_three", event.timeNs(), List.of(event.robot()), "it is 7");
      }
    }
  }

  @TempDir Path folder;

  @ExtendWith(OnlyFromHere.class)
  static class Fixture {

    private final List<Long> seeds = new ArrayList<>();

    @StarlTest(seeds = 20)
    void good(Simulation.Builder simulation, TestInfo info, RunChecks afterwards, long seed) {
      assertThat(info.getTestMethod()).isPresent();
      simulation.robots(3, gvh -> new Counter(gvh, false)).monitor(CountsToThree::new);
      afterwards.check(result -> {
        assertThat(result.seed()).isEqualTo(seed);
        assertThat(result.results().values()).hasSize(3).containsOnly(List.of("counted"));
        seeds.add(result.seed());
      });
      afterwards.check(result -> assertThat(seeds).isSorted().endsWith(seed));
    }

    @StarlTest(seeds = 20, firstSeed = 8)
    void planted(Simulation.Builder simulation, long seed) {
      simulation.robots(
          2, gvh -> new Counter(gvh, seed % 5 == 0 && gvh.id.name().name().equals("bot1")));
      simulation.monitor(CountsToThree::new);
    }

    @StarlTest(seeds = 2, explore = 20)
    void impatient(Simulation.Builder simulation) {
      simulation.robots(2, Impatient::new);
    }

    @StarlTest(seeds = 3)
    void throwing(Simulation.Builder simulation) {
      simulation.robots(
          1,
          gvh -> {
            throw new IllegalStateException("on purpose");
          });
    }

    @StarlTest(seeds = 3, atMost = "250ms")
    void tooLong(Simulation.Builder simulation) {
      simulation.robots(2, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 3, atMost = "1ms")
    void longEnough(Simulation.Builder simulation) {
      simulation
          .settings(SimSettings.builder().duration(Duration.ofSeconds(1)).build())
          .robots(2, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 2)
    void notLonger(Simulation.Builder simulation) {
      simulation.robots(1, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 10)
    void wrongResult(Simulation.Builder simulation, RunChecks afterwards) {
      simulation.robots(2, gvh -> new Counter(gvh, false));
      afterwards.check(result -> assertThat(result.seed()).isLessThan(3));
    }

    @StarlTest(seeds = 4, faults = "crash(bot1,at=150ms)")
    void crashed(Simulation.Builder simulation, RunChecks afterwards) {
      simulation.robots(2, gvh -> new Counter(gvh, false));
      afterwards.check(result -> assertThat(result.results()).hasSize(2));
    }

    @StarlTest(seeds = 20, chaos = Envelope.NETWORK)
    void chaotic(Simulation.Builder simulation, RunChecks afterwards) {
      simulation.robots(2, gvh -> new Counter(gvh, false));
      afterwards.check(result -> assertThat(result.seed()).isLessThan(20));
    }

    @StarlTest(seeds = 2, faults = "crush(bot1)")
    void badFault(Simulation.Builder simulation) {
      simulation.robots(2, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 2)
    void badScenario(Simulation.Builder simulation, long seed) {
      assertThat(seed).isEqualTo(1);
      simulation.robots(2, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 3)
    void ownSeed(Simulation.Builder simulation) {
      simulation.seed(42).robots(2, gvh -> new Counter(gvh, false));
    }

    @StarlTest(seeds = 3)
    void empty(Simulation.Builder simulation) {
      simulation.monitor(CountsToThree::new);
    }

    @StarlTest
    void assuming(Simulation.Builder simulation) {
      assumeTrue(simulation.settings().robots() == 17);
    }
  }

  private EngineExecutionResults run(String method, String seed) {
    Class<?>[] types =
        switch (method) {
          case "good" ->
              new Class<?>[] {
                Simulation.Builder.class, TestInfo.class, RunChecks.class, long.class
              };
          case "planted", "badScenario" -> new Class<?>[] {Simulation.Builder.class, long.class};
          case "wrongResult", "crashed", "chaotic" ->
              new Class<?>[] {Simulation.Builder.class, RunChecks.class};
          default -> new Class<?>[] {Simulation.Builder.class};
        };
    return EngineTestKit.engine("junit-jupiter")
        .configurationParameter(FIXTURE, "yes")
        .configurationParameter(StarlExtension.SEED, seed)
        .configurationParameter(RunFiles.FOLDER, folder.toString())
        .selectors(selectMethod(Fixture.class, method, types))
        .execute();
  }

  private static Throwable failure(EngineExecutionResults results) {
    assertThat(results.testEvents().failed().count()).as("failed tests").isOne();
    return results
        .testEvents()
        .failed()
        .list()
        .get(0)
        .getRequiredPayload(org.junit.platform.engine.TestExecutionResult.class)
        .getThrowable()
        .orElseThrow();
  }

  private List<String> failureLines(String method, String seed) {
    return failure(run(method, seed)).getMessage().lines().toList();
  }

  @Test
  void theTestPassesIfEverySeedPasses() {
    for (String good : List.of("good", "longEnough")) {
      run(good, "").testEvents().assertStatistics(stats -> stats.started(1).succeeded(1));
    }
  }

  @Test
  void anOrderThatNoSeedDrawsIsExploredAndItsFaultsAreNamed() {
    List<String> lines = failureLines("impatient", "");
    assertThat(lines.get(0)).endsWith("impatient: 1 of 2 runs went wrong");
    assertThat(lines.get(1)).startsWith("  seed 1: ").contains("heard nothing");
    assertThat(lines).anyMatch(line -> line.startsWith("faults of seed 1: delay("));
    assertThat(failureLines("impatient", "1").get(1)).isEqualTo(lines.get(1));
  }

  @Test
  void aPlantedBugIsCaughtAndThePrintedSeedReplaysIt() {
    List<String> lines = failureLines("planted", "");
    assertThat(lines.get(0)).endsWith("StarlTestTest$Fixture#planted: 4 of 20 runs went wrong");
    assertThat(lines.subList(1, 5))
        .extracting(line -> line.substring(0, line.indexOf(':')))
        .containsExactly("  seed 10", "  seed 15", "  seed 20", "  seed 25");
    assertThat(lines.get(1)).endsWith("counts_to_three violated at 0.300 s by bot1: it is 7");
    String replay = lines.get(lines.size() - 1);
    assertThat(replay)
        .startsWith("replay: mvn test '-Dtest=org.starl.sim.junit.StarlTestTest$Fixture#planted' ");
    Matcher seed = SEED.matcher(replay);
    assertThat(seed.find()).isTrue();
    List<String> again = failureLines("planted", seed.group(1));
    assertThat(again.get(0)).endsWith("planted: 1 of 1 runs went wrong");
    assertThat(again.subList(1, again.size())).contains(lines.get(1)).endsWith(replay);
  }

  @Test
  void aFailedTestLeavesTheTraceOfItsFirstBadRun() throws IOException {
    List<String> lines = failureLines("planted", "");
    Path trace = folder.resolve("org.starl.sim.junit.StarlTestTest$Fixture.planted-seed-10.trace");
    assertThat(lines)
        .contains("trace: " + trace)
        .contains("for a picture, add org.starl:starl-sim-view to the test's dependencies");
    List<TraceEvent> events = new ArrayList<>();
    try (TraceReader reader =
        new TraceReader(
            trace.toString(),
            Files.newInputStream(trace),
            Vocabulary.NONE.variables(Instance.APP.primitive(), COUNT))) {
      assertThat(reader.header().scenarioSeed()).isEqualTo(10);
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        events.add(event);
      }
    }
    assertThat(events)
        .filteredOn(event -> event instanceof TraceEvent.Variable v && isSeven(v))
        .hasSize(1);
    assertThat(folder).isDirectoryContaining(trace::equals);
  }

  @Test
  void filesOfAnEarlierFailureOfTheTestAreRemoved() throws IOException {
    Path old = folder.resolve("org.starl.sim.junit.StarlTestTest$Fixture.good-seed-3.html");
    Path ofAnother =
        folder.resolve("org.starl.sim.junit.StarlTestTest$Fixture.goodish-seed-3.html");
    Files.createFile(old);
    Files.createFile(ofAnother);
    run("good", "");
    assertThat(old).doesNotExist();
    assertThat(ofAnother).exists();
  }

  @Test
  void aTestWhoseAppThrowsLeavesATraceToo() {
    assertThat(failureLines("throwing", "")).anyMatch(line -> line.startsWith("trace: "));
  }

  @Test
  void aFolderThatCannotBeWrittenIsNamedInTheMessage() throws IOException {
    folder = Files.createFile(folder.resolve("file"));
    assertThat(failureLines("planted", ""))
        .anyMatch(line ->
            line.startsWith("the run of seed 10 cannot be shown: ")
                && line.contains(folder.toString()));
  }

  @Test
  void aSingleGoodSeedPasses() {
    run("planted", "11").testEvents().assertStatistics(stats -> stats.started(1).succeeded(1));
  }

  @Test
  void theSeedCanBeASystemProperty() {
    System.setProperty(StarlExtension.SEED, "25");
    try {
      Throwable failure =
          failure(
              EngineTestKit.engine("junit-jupiter")
                  .enableImplicitConfigurationParameters(true)
                  .configurationParameter(FIXTURE, "yes")
                  .selectors(
                      selectMethod(Fixture.class, "planted", Simulation.Builder.class, long.class))
                  .execute());
      assertThat(failure).hasMessageContaining("1 of 1 runs").hasMessageContaining("seed 25: ");
    } finally {
      System.clearProperty(StarlExtension.SEED);
    }
  }

  @Test
  void anExceptionOfAnAppIsTheCause() {
    Throwable failure = failure(run("throwing", ""));
    assertThat(failure).hasMessageContaining("3 of 3 runs").hasMessageContaining("on purpose");
    assertThat(failure).hasRootCauseMessage("on purpose");
  }

  @Test
  void aRunThatDoesNotFinishFails() {
    List<String> lines = failureLines("tooLong", "");
    assertThat(lines.get(1))
        .startsWith("  seed 1: not finished: [bot0, bot1]; slow or a livelock; bot0 waits at ");
    assertThat(lines)
        .anyMatch(line -> line.matches("\\s+bot1 waits at StarlTestTest.java:\\d+ .callStarL. .*"));
  }

  @Test
  void aMethodThatSetsItsOwnSeedFails() {
    assertThat(failure(run("ownSeed", "")))
        .hasMessageContaining("#ownSeed: the method sets seed 42, so every run would be the same");
  }

  @Test
  void aSimulationWithoutRobotsFails() {
    assertThat(failure(run("empty", "")))
        .hasMessageContaining("#empty: a simulation without robots");
  }

  @Test
  void aFailedCheckFailsTheTestAndTheSeedsAreCounted() {
    List<String> lines = failureLines("wrongResult", "");
    assertThat(lines.get(0)).endsWith("8 of 10 runs went wrong");
    assertThat(lines).anyMatch(line -> line.startsWith("  seed 3: ")).contains("  and 3 more");
    assertThat(failure(run("wrongResult", ""))).cause().isInstanceOf(AssertionError.class);
  }

  @Test
  void faultsAreAppliedAndReported() {
    assertThat(failureLines("crashed", ""))
        .hasSizeGreaterThan(4)
        .contains("faults of seed 1: crash(bot1,at=150ms)");
    assertThat(failureLines("chaotic", ""))
        .anyMatch(line -> line.startsWith("faults of seed 20: "));
  }

  @Test
  void anErrorInTheAnnotationIsReported() {
    assertThat(failure(run("badFault", "")))
        .hasMessageContaining("faults: ")
        .hasMessageContaining("crush");
    assertThat(failure(run("good", "x"))).hasMessageContaining("starl.seed='x': expected a seed");
  }

  @Test
  void anExceptionOfAScenarioNamesTheSeed() {
    Throwable failure = failure(run("badScenario", ""));
    assertThat(failure).isInstanceOf(AssertionError.class);
    assertThat(failure.getSuppressed())
        .singleElement()
        .extracting(Throwable::getMessage)
        .asString()
        .startsWith("seed 2; replay: mvn test ");
  }

  @Test
  void aFailedAssumptionAbortsTheTest() {
    run("assuming", "").testEvents().assertStatistics(stats -> stats.started(1).aborted(1));
  }

  /** Runs two good fixtures; a JVM of its own, without the option that opens {@code java.lang}. */
  static final class WithoutOpenedLang {
    public static void main(String[] args) {
      new StarlTestTest().runFixtures(List.of("longEnough", "notLonger"));
    }
  }

  private void runFixtures(List<String> methods) {
    folder = Path.of("");
    EngineTestKit.engine("junit-jupiter")
        .configurationParameter(FIXTURE, "yes")
        .selectors(
            methods.stream()
                .map(method -> selectMethod(Fixture.class, method, Simulation.Builder.class))
                .toArray(MethodSelector[]::new))
        .execute();
  }

  @Test
  @Tag("realtime")
  void theReasonForPlatformThreadsIsLoggedOnce() throws IOException, InterruptedException {
    Process child =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                WithoutOpenedLang.class.getName())
            .redirectErrorStream(true)
            .start();
    String printed = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(child.waitFor()).as(printed).isZero();
    assertThat(printed.lines())
        .filteredOn(line -> line.contains("robots run on platform threads"))
        .hasSize(1);
  }
}
