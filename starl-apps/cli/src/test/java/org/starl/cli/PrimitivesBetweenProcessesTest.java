package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The primitives' workloads, which campaigns run simulated, between processes in real time, a fifth of
 * all copies lost: the same robots under the same specifications. How long it takes is the machine's;
 * that it comes to its end, and is safe, is not.
 */
class PrimitivesBetweenProcessesTest {

  @TempDir private Path folder;

  private Cli run(String primitive, String busy, String... more) {
    List<String> words =
        new ArrayList<>(List.of("run", primitive, "--processes", "--robots", "3", "--loss", "0.2"));
    words.addAll(List.of("--seed", "7", "--for", "150s", "--set", "busy=" + busy));
    words.addAll(List.of("--png", folder.resolve("a.png").toString()));
    words.addAll(List.of(more));
    return Cli.run(words.toArray(String[]::new));
  }

  @ParameterizedTest
  @ValueSource(strings = {"geocast", "registration", "mutex", "election"})
  void theContractIsKept(String primitive) {
    Cli cli = run(primitive, "1s", "--set", "rounds=2");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text())
        .contains("3 processes came 3 times to the end of the app", "safe: ")
        .doesNotContain(" 0 copies lost");
  }

  @Test
  void aLeaderIsFoundAnewWhenAProcessIsKilled() {
    Cli cli = run("election", "4s", "--set", "rounds=4", "--kill", "bot2@2s");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text())
        .contains("bot2's process ", " was killed at ", "safe: ")
        .contains("3 processes came 2 times to the end of the app");
  }

  @Test
  void eachRoundIsANewStartOverTheSameStorage() {
    Cli cli = run("registration", "0s", "--set", "rounds=1", "--rounds", "2");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text()).contains("3 processes came 6 times to the end of the app", "safe: ");
  }
}
