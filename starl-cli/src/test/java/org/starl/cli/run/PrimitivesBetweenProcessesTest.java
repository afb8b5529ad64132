package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Cli;

/**
 * The primitives' workloads, which campaigns simulate, between processes in real time with a fifth
 * of all copies lost: the same robots under the same specifications. The machine decides how long a
 * run takes, but every run must come to its end and be safe. Most of a run is waiting, so several
 * run at a time.
 */
@Tag("realtime")
class PrimitivesBetweenProcessesTest {

  private static final int AT_A_TIME = 3;

  private static final ExecutorService POOL = Executors.newFixedThreadPool(AT_A_TIME);
  private static final Map<String, Future<Cli>> RUNS = new TreeMap<>();

  @BeforeAll
  static void start(@TempDir Path folder) {
    start(folder, "kill", "election", "4s", "--set", "rounds=4", "--kill", "bot2@2s");
    start(folder, "rounds", "registration", "0s", "--set", "rounds=1", "--rounds", "2");
    for (String primitive : List.of("geocast", "registration", "mutex", "election")) {
      start(folder, primitive, primitive, "0s", "--set", "rounds=2");
    }
  }

  private static void start(
      Path folder, String name, String primitive, String busy, String... more) {
    List<String> words =
        new ArrayList<>(List.of("run", primitive, "--processes", "--robots", "3", "--loss", "0.2"));
    words.addAll(List.of("--seed", "7", "--for", "150s", "--set", "busy=" + busy));
    words.addAll(List.of("--png", folder.resolve(name + ".png").toString()));
    words.addAll(List.of(more));
    RUNS.put(name, POOL.submit(() -> Cli.run(words.toArray(String[]::new))));
  }

  @AfterAll
  static void end() {
    POOL.shutdownNow();
  }

  private static Cli result(String name) throws Exception {
    Cli cli = Objects.requireNonNull(RUNS.get(name)).get();
    assertThat(cli.status()).as("%s", cli).isZero();
    return cli;
  }

  @ParameterizedTest
  @ValueSource(strings = {"geocast", "registration", "mutex", "election"})
  void thePrimitiveKeepsItsContract(String primitive) throws Exception {
    assertThat(result(primitive).text())
        .contains("3 processes came 3 times to the end of the app", "safe: ")
        .doesNotContain(" 0 copies lost");
  }

  @Test
  void anotherLeaderIsElectedWhenAProcessIsKilled() throws Exception {
    assertThat(result("kill").text())
        .contains("bot2's process ", " was killed at ", "safe: ")
        .contains("3 processes came 2 times to the end of the app");
  }

  @Test
  void eachRoundIsANewStartOverTheSameStorage() throws Exception {
    assertThat(result("rounds").text())
        .contains("3 processes came 6 times to the end of the app", "safe: ");
  }
}
