package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.NotEmpty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.Shell;

/** Two runs side by side. */
class CompareTest {

  private static final String TWIN = "hello --seed 7 --for 3s";

  private static Cli compare(Object... words) {
    return Cli.line(Apps.ALL, "compare", words);
  }

  @Test
  void aRunEqualsItselfAndItsTrace(@TempDir Path folder) {
    Path trace = folder.resolve("hello.trace");
    Path picture = folder.resolve("hello.png");
    Cli.line(Apps.ALL, "run " + TWIN + " --trace", trace, "--png", picture);
    for (Object other : List.of("run " + TWIN, Shell.launcher() + " run " + TWIN, trace)) {
      Cli cli = compare(TWIN, other);
      assertThat(cli.status()).as("%s", cli).isZero();
      assertThat(cli.out().getLast()).as("%s", cli).matches("equal: \\d+ events");
    }
  }

  @Test
  void theFirstDifferenceOfTwinsIsTold(@TempDir Path folder) throws Exception {
    Path page = folder.resolve("both.html");
    Cli cli = compare(TWIN, TWIN + " --fault 'crash(bot0,at=2s)'", "--html", page);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out().get(2)).startsWith("first difference at 2.000000000 s, event ");
    assertThat(cli.out().get(4)).isEqualTo("  B: bot0: begin crash(bot0,at=2s)");
    assertThat(Files.readString(page))
        .contains("The runs first differ at 2.000 s", "crash(bot0,at=2s)", "data-at=\"2000.0\"")
        .doesNotContain("{{", "http:", "https:");
  }

  @Test
  void theEndOfTheShorterRunIsADifference() {
    Cli cli = compare(TWIN, "hello --seed 7 --for 2s");
    assertThat(cli.out().get(3) + cli.out().get(4)).contains("no more events", "bot");
  }

  @Test
  void anEventIsToldInWordsAndInJsonAsInATrace() {
    String[] runs = {"mutex --seed 5", "mutex --seed 5 --loss 0.1"};
    assertThat(compare(runs[0], runs[1]).out())
        .anyMatch(line -> line.startsWith("  A: bot0 receives from bot0, registration/crossing: "))
        .contains("  B: bot4 does not receive a datagram of bot0: loss");
    assertThat(compare(runs[0], runs[1], "--json").out().getLast())
        .contains("\"b_event\":\"{\\\"kind\\\":\\\"dropped\\\"");
  }

  @Test
  void badInputIsToldBeforeAnythingIsWritten(@TempDir Path folder) throws Exception {
    Path page = folder.resolve("x.html");
    compare("helo --seed 7", TWIN, "--html", page).assertRefused("A: 'helo --seed 7'", "hello");
    compare(TWIN, "hello", "--html", page).assertRefused("B: 'hello'", "--seed");
    compare(TWIN, "hello --seed 7 --nope", "--html", page).assertRefused("B: ", "--nope");
    compare(TWIN, "hello --seed 'x", "--html", page).assertRefused("B: ", "quote");
    compare(TWIN, "hello --seed x", "--html", page).assertRefused("B: ", "x");
    compare(TWIN, folder.resolve("no.trace"), "--html", page).assertRefused("no.trace");
    compare(TWIN, TWIN, "--html", folder.resolve("x.png")).assertRefused("--html", ".html");
    assertThat(folder).isEmptyDirectory();
  }

  @Property
  void wordsThatAreQuotedAreReadBack(@ForAll @NotEmpty List<String> words) {
    String line = words.stream().map(Shell::quote).collect(Collectors.joining(" "));
    assertThat(Shell.words(line)).isEqualTo(words);
  }
}
