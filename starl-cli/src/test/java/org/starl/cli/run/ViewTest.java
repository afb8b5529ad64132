package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import org.junit.jupiter.api.Test;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;
import org.starl.sim.view.Window;

class ViewTest {

  @Test
  void withoutADisplayOneLineNamesTheAlternatives() {
    assumeThat(Window.isPossible()).as("this machine has a screen").isFalse();
    Cli cli = Cli.run("run", "hello", "--seed", "7", "--view");
    assertThat(cli.status()).isEqualTo(ExitStatus.MISSING_DEPENDENCY);
    assertThat(cli.err())
        .singleElement()
        .asString()
        .contains("no display", "xvfb-run", "starl record");
  }

  @Test
  void processesHaveNoWindow() {
    Cli cli = Cli.run("run", "hello", "--seed", "7", "--view", "--processes");
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).singleElement().asString().contains("--view");
  }
}
