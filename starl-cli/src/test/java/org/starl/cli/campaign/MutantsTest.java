package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;

/** {@code starl mutants}, in its second process, too. */
class MutantsTest {

  @Test
  @Tag("realtime")
  void bugsSurviveThatNoSpecificationSees() {
    Cli cli =
        Cli.run("mutants", "hello", "--seeds", "1..2", "--classes", "org.starl.apps.hello.logic.*");
    assertThat(cli.status()).as("%s", cli).isZero();
    List<String> lines = cli.out();
    // No specification says where hello drives.
    assertThat(lines).anyMatch(line -> line.matches("survived: Hello.java:\\d+: .*doMove.*"));
    assertThat(lines.getLast()).matches("\\d+ bugs tried with seeds 1..2: [1-9].* 0 refused.*");
  }

  @Test
  void classesThatAreNotThereAreRefused() {
    Cli cli = Cli.run("mutants", "hello", "--classes", "org.nowhere.*");
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err())
        .singleElement()
        .asString()
        .contains("--classes: 'org.nowhere.*': expected");
  }
}
