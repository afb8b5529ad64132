package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.sim.fault.FaultGrammar;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;

/** Faults from the command line and from scenario files. */
class FaultsTest {

  private static final String CRASH = "crash(bot1,at=1s,restart=2s)";
  private static final String STUCK = "stuck(bot2,at=500ms,for=1s)";

  @TempDir private Path folder;

  /** A trace's header, and its faults as {@code robot name detail}. */
  private record Traced(TraceHeader header, List<String> faults, byte[] bytes) {}

  private Traced run(String... args) throws IOException {
    Path trace = folder.resolve("a.trace");
    List<String> all = new ArrayList<>(List.of("run"));
    all.addAll(List.of(args));
    all.addAll(List.of("--png", folder.resolve("a.png").toString(), "--trace", trace.toString()));
    Cli cli = Cli.run(all.toArray(String[]::new));
    assertThat(cli.status()).as("%s", cli).isLessThanOrEqualTo(1);
    List<String> faults = new ArrayList<>();
    try (InputStream in = Files.newInputStream(trace);
        TraceReader reader = new TraceReader("a.trace", in, PrimitiveVocabulary.ALL)) {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        if (event instanceof TraceEvent.Fault fault) {
          faults.add((fault.robot() + " " + fault.name() + " " + fault.detail()).strip());
        }
      }
      return new Traced(reader.header(), faults, Files.readAllBytes(trace));
    }
  }

  @Test
  void faultsHappenAndStandInTheHeader() throws IOException {
    Traced traced = run("hello", "--seed", "3", "--fault", CRASH, "--fault", STUCK);
    assertThat(traced.header().settings()).containsEntry("faults", CRASH + "; " + STUCK);
    assertThat(traced.faults())
        .containsExactly(
            "bot2 begin " + STUCK,
            "bot1 begin " + CRASH,
            "bot1 crash",
            "bot2 end " + STUCK,
            "bot1 restart lost",
            "bot1 end " + CRASH,
            "world healed");
  }

  @Test
  void aFaultInAHeaderReadsBackEqual() throws IOException {
    Traced first = run("hello", "--seed", "3", "--fault", CRASH, "--fault", "noise(all,9mm)");
    List<String> args = new ArrayList<>(List.of("hello", "--seed", "3"));
    first
        .header()
        .settings()
        .forEach((key, value) -> {
          if (!value.isEmpty()) {
            args.addAll(List.of("--set", key + "=" + value));
          }
        });
    assertThat(run(args.toArray(String[]::new)).bytes()).isEqualTo(first.bytes());
  }

  @Test
  void aScenarioFileHasFaultsToo() throws IOException {
    List<String> faults =
        List.of(
            "faults: [" + CRASH + ", " + STUCK + "]",
            "faults: [\"" + CRASH + "\", \"" + STUCK + "\"]",
            "faults:\n  - " + CRASH + "\n  - " + STUCK,
            "faults: " + CRASH + "; " + STUCK);
    for (String text : faults) {
      Path file = Files.writeString(folder.resolve("my.yaml"), "app: hello\n" + text + "\n");
      Traced traced = run(file.toString(), "--seed", "3");
      assertThat(traced.header().settings()).containsEntry("faults", CRASH + "; " + STUCK);
    }
    Files.writeString(folder.resolve("my.yaml"), "app: hello\nfaults: [" + CRASH + "]\n");
    Traced more = run(folder.resolve("my.yaml").toString(), "--seed", "3", "--fault", STUCK);
    assertThat(more.header().settings()).containsEntry("faults", CRASH + "; " + STUCK);
  }

  @Test
  void chaosIsTheAppsOwn() throws IOException {
    Traced flag = run("hello", "--seed", "3", "--chaos", "--set", "chaosFor=3s");
    assertThat(flag.header().settings()).containsEntry("chaos", "spatial");
    assertThat(flag.faults()).isNotEmpty().noneMatch(line -> line.contains("crash"));
    Path file = folder.resolve("my.yaml");
    Files.writeString(file, "app: hello\nchaos: true\nchaosFor: 3s\n");
    assertThat(run(file.toString(), "--seed", "3").faults()).isEqualTo(flag.faults());
    Files.writeString(file, "app: hello\nchaos: false\n");
    assertThat(run(file.toString(), "--seed", "3").faults()).isEmpty();
    Traced logical = run("hello", "--seed", "3", "--set", "chaos=logical");
    assertThat(logical.header().settings()).containsEntry("chaos", "logical");
  }

  @Test
  void theReplayCommandCarriesThem() {
    // No robot arrives on wheels that are stuck forever.
    Cli cli =
        Cli.run(
            "campaign",
            "intersection",
            "--seeds",
            "4..4",
            "--for",
            "5s",
            "--chaos",
            "--fault",
            "stuck(all)",
            "--fault",
            "loss(0.1,from=bot1)");
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.err())
        .last()
        .isEqualTo(
            "replay: ./starl run intersection --seed 4 --for 5s --fault 'stuck(all)'"
                + " --fault 'loss(0.1,from=bot1)' --chaos");
  }

  @Test
  void runsWithFaultsAreDeterministic() {
    Cli cli =
        Cli.run(
            "verify-determinism",
            "hello",
            "--seed",
            "5",
            "--fault",
            "compute(any,3ms)",
            "--fault",
            CRASH,
            "--chaos");
    assertThat(cli.status()).as("%s", cli).isZero();
  }

  @Test
  void listShowsEveryKindAndEnvelope() {
    Cli cli = Cli.run("list");
    for (FaultGrammar.Kind kind : FaultGrammar.kinds()) {
      assertThat(cli.out()).contains("  " + kind.usage() + "  " + kind.meaning());
    }
    assertThat(cli.out()).anyMatch(line -> line.startsWith("  logical  "));
  }
}
