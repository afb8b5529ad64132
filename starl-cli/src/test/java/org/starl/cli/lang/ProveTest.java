package org.starl.cli.lang;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;

class ProveTest {

  private static final String LAMP =
      """
      automaton Lamp[PIDS]
      state by: option[PIDS]
      start by = none
      action take(i: PIDS)
        pre by = none
        eff by := some(i)
      invariant Free: by = none
      """;

  @TempDir private Path folder;

  @Test
  void provedInvariantsGiveStatusZero() throws IOException {
    Cli cli = Cli.run("prove", file(LAMP.replace("by = none\n", "by = by\n")));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out())
        .containsExactly(
            "Lamp: start is possible",
            "Lamp: Free holds, for any number of PIDS",
            "Lamp: take can happen");
  }

  @Test
  void stepThatBreaksAnInvariantGivesStatusOne() throws IOException {
    Cli cli = Cli.run("prove", file(LAMP));
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.out())
        .contains(
            "Lamp: Free is not kept by take",
            "  before  all empty, 0 or none",
            "  action  take(bot0)",
            "  after   by = some(bot0)");
  }

  @Test
  void whatIsTooDeepIsToldByTheReaderOrTheProver() throws IOException {
    for (int conjuncts = 500; conjuncts <= 4_000; conjuncts *= 2) {
      Cli cli = Cli.run("prove", file(LAMP.strip() + " and by = by".repeat(conjuncts) + "\n"));
      if (conjuncts == 4_000 || cli.status() != ExitStatus.VIOLATED) {
        assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.BAD_INPUT);
        assertThat(cli.err().getFirst()).contains("lamp.starl").contains("nests too deeply");
      }
    }
  }

  @Test
  void questionsAreKeptInAFolderAlone() throws IOException {
    String file = file(LAMP);
    Cli cli = Cli.run("prove", file, "--keep", file);
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err().getFirst())
        .startsWith("starl: --keep: '" + file + "/Lamp/")
        .endsWith("; expected the name of a file in a writable folder");
  }

  @Test
  void branchesOfAProgramAreToldWithTheirPlaces() throws IOException {
    String file = file(CheckTest.TWICE);
    Cli cli = Cli.run("prove", file);
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.out())
        .contains(
            "Twice: second_may_do_register is not kept by first_to_second",
            "  first_to_second is at " + file + ":5:3");
  }

  @Test
  void obligationsAreKeptInAFolder() throws IOException {
    Path kept = folder.resolve("kept");
    Cli cli = Cli.run("prove", file(LAMP), "--keep", kept.toString());
    assertThat(cli.err()).isEmpty();
    assertThat(kept.resolve("Lamp/take-keeps-Free.smt2"))
        .content()
        .contains("; action take(i: PIDS)", "(check-sat)");
  }

  @Test
  void aQuestionIsKeptWhollyOrNotAtAll() throws IOException {
    // What is written goes to a file beside it first, which is there already.
    Path kept = Files.createDirectories(folder.resolve("kept/Lamp"));
    String part = ".take-keeps-Free.smt2.%d.part".formatted(ProcessHandle.current().pid());
    Files.createFile(kept.resolve(part));
    Cli cli = Cli.run("prove", file(LAMP), "--keep", folder.resolve("kept").toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(kept.resolve("take-keeps-Free.smt2")).doesNotExist();
  }

  @Test
  void badInputIsToldInOneLine() throws IOException {
    String file = file(LAMP.replace("some(i)", "i"));
    Cli wrong = Cli.run("prove", file);
    assertThat(wrong.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(wrong.err())
        .containsExactly(file + ":6:13: 'i' is of type PIDS; expected option[PIDS]: some(i)");
    Cli missing = Cli.run("prove", "nothing.starl");
    assertThat(missing.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(missing.err())
        .containsExactly(
            "starl: nothing.starl: no such file; expected a source of automata (.starl)");
    Cli type = Cli.run("prove", file(LAMP.replace("state", "state n: option[set[nat]]")));
    assertThat(type.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(type.err())
        .singleElement()
        .asString()
        .matches("starl: .*\\.starl:\\d+:1: Lamp: the type set\\[nat] inside .*");
    Cli limit = Cli.run("prove", file, "--limit", "0");
    assertThat(limit.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(limit.err()).singleElement().asString().startsWith("starl: --limit: '0': expected");
  }

  private String file(String text) throws IOException {
    return Files.writeString(folder.resolve("lamp.starl"), text).toString();
  }
}
