package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.cli.command.Apps;
import org.starl.cli.request.RunRequest;
import org.starl.sim.Setting;
import org.starl.sim.fault.FaultGrammar;

/** {@code starl completion}: what shells offer. */
class CompletionTest {

  @TempDir private Path folder;

  /** What bash offers for the last of the words. */
  private List<String> bash(String... words) throws IOException, InterruptedException {
    Path script = folder.resolve("starl.bash");
    Files.writeString(script, Cli.run("completion", "bash").text());
    String line =
        "source '%s'; COMP_WORDS=(%s); COMP_CWORD=%d; COMP_LINE='%s'; compopt() { :; }; _starl; printf '%%s\\n' \"${COMPREPLY[@]}\""
            .formatted(
                script,
                String.join(" ", Arrays.stream(words).map(word -> "'" + word + "'").toList()),
                words.length - 1,
                String.join(" ", words));
    Process bash = new ProcessBuilder("bash", "-c", line).redirectErrorStream(true).start();
    return new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
        .lines()
        .toList();
  }

  @Test
  @Tag("realtime")
  void bashCompletesCommandsAppsOptionsAndValues() throws IOException, InterruptedException {
    assertThat(bash("starl", "ca")).containsExactly("campaign");
    assertThat(bash("starl", "deploy", "")).contains("run", "check", "plan");
    assertThat(bash("starl", "run", "int")).containsExactly("intersection");
    assertThat(bash("starl", "run", "hello", "--se")).contains("--seed", "--set");
    assertThat(bash("starl", "run", "hello", "--set", "messageL")).containsExactly("messageLoss=");
    assertThat(bash("starl", "explore", "mutex", "--fault", "crash"))
        .singleElement()
        .asString()
        .startsWith("crash\\(");
  }

  @Test
  void allThatIsRegisteredIsOffered() {
    for (String shell : new String[] {"bash", "zsh", "fish"}) {
      Cli cli = Cli.run("completion", shell);
      assertThat(cli.status()).isZero();
      for (Demo demo : Apps.ALL.all()) {
        assertThat(cli.text()).contains(demo.name());
        for (Parameter parameter : demo.parameters()) {
          assertThat(cli.text()).contains(parameter.key() + "=");
        }
      }
      for (Setting<?> setting : RunRequest.known()) {
        assertThat(cli.text()).contains(setting.key() + "=");
      }
      FaultGrammar.kinds().forEach(kind -> assertThat(cli.text()).contains(kind.usage()));
    }
  }

  @Test
  void fishKnowsEachCommandAndOption() {
    List<String> fish = Cli.run("completion", "fish").out();
    assertThat(fish).anyMatch(line -> line.contains("-eq 1' -f -a campaign -d "));
    assertThat(fish).anyMatch(line -> line.contains("'__starl_at deploy' -f -a run -d "));
    assertThat(fish).anyMatch(line -> line.contains("'__starl_at run' -l seed -x -d "));
    assertThat(fish).anyMatch(line -> line.contains("'__starl_at run' -l ideal -d "));
    assertThat(fish).anyMatch(line -> line.contains("'__starl_at run' -l trace -r -d "));
  }

  @Test
  void anotherShellIsRefused() {
    Cli.run("completion", "tcsh").assertRefused("'tcsh'", "BASH");
  }
}
