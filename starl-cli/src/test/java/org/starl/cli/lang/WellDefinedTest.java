package org.starl.cli.lang;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;

/** What has no value is told by each tool: the table of docs/language.md. */
class WellDefinedTest {

  private static final String LOCK =
      """
      automaton Lock[P]
      state holder: option[P]
      start holder = none
      action take(p: P)
        pre holder = none
        eff holder := some(p)

      """;

  @TempDir private Path folder;

  private Path source(String condition, String effect, String more) throws IOException {
    String text =
        LOCK
            + """
            automaton A[P]
            type Form = left | right(by: P)
            state
              o: option[P]
              s: set[P]
              l: list[P]
              f: Form
              n: nat
              t: time
              m: [P -> nat]
              r: 0..3
            uses lock: Lock[P]
            start o = none, s = {}, l = [], f = left, n = 0, t = 0, r = 0,
              (forall p: P :: m(p) = 0), lock.start?
            fun first: P = head(l)
            action act(i: P, j: P)
              pre %s
              eff %s
            invariant True: n = n
            %s
            """
                .formatted(condition, effect, more);
    return Files.writeString(folder.resolve("A.starl"), text);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          s := {the(o)} | o != none | the(none)
          s := {head(l)} | l != [] | head([])
          s := {first} | l != [] | head([])
          l := tail(l) | l != [] | tail([])
          s := {choose k: P :: k in s} | s != {} | nothing satisfies the condition of 'choose'
          r := r + 1 | r < 3 | not in 0..3
          s := {f.by} | f is right | 'by' of
          n := n - 1 | n > 0 | negative
          t := t - 1 | t >= 1 | negative
          t := 1 / n | n > 0 | division by 0
          m(i) := 1, m(j) := 2 | i != j | changes one place twice
          lock.take(i) | lock.holder = none | where it is not enabled
          lock.take(i), lock.take(j) | i = j, lock.holder = none | changes one place twice
          s := {k: P ~ k in s or k = the(o)} | o != none | the(none)
          m := [k: P -> m(k) - 1] | forall k: P :: m(k) > 0 | negative
          if lock.holder = none then lock.take(i), n := n - 1 | n > 0 | negative
          """)
  void effectIsUndefinedForCheckAndProveUnlessItsConditionPreventsIt(
      String effect, String condition, String told) throws IOException {
    String right = effect.replace('~', '|');
    for (boolean isGuarded : new boolean[] {false, true}) {
      Path file = source(isGuarded ? condition : "true", right, "");
      Cli check = Cli.run("check", file.toString(), "--robots", "2");
      Cli prove = Cli.run("prove", file.toString());
      if (isGuarded) {
        assertThat(check.status()).as("%s", check).isNotEqualTo(ExitStatus.VIOLATED);
        assertThat(prove.out())
            .noneMatch(line -> line.contains(told))
            .anyMatch(line -> line.startsWith("A: True holds"));
      } else {
        assertThat(check.status()).as("%s", check).isEqualTo(ExitStatus.VIOLATED);
        assertThat(prove.status()).as("%s", prove).isEqualTo(ExitStatus.VIOLATED);
        assertThat(check.out()).anyMatch(line -> line.startsWith("A (P 2): a step is undefined"));
        assertThat(prove.out())
            .anyMatch(line -> line.startsWith("A: act ") && line.contains(told))
            .noneMatch(line -> line.startsWith("A: True holds"));
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          the(o) in s | A: Bad has no value: the(none)
          o != none and the(o) in s or n - 1 >= 0 | A: Bad makes a number negative
          forall p: P :: m(p) - 1 >= 0 | A: Bad makes a number negative
          """)
  void invariantIsUndefinedForCheckAndProve(String invariant, String told) throws IOException {
    Path file = source("n > 0", "n := n", "invariant Bad: " + invariant);
    Cli check = Cli.run("check", file.toString(), "--robots", "2");
    Cli prove = Cli.run("prove", file.toString());
    assertThat(check.status()).as("%s", check).isEqualTo(ExitStatus.VIOLATED);
    assertThat(prove.status()).as("%s", prove).isEqualTo(ExitStatus.VIOLATED);
    assertThat(check.out().getLast()).isNotEmpty();
    assertThat(check.out()).anyMatch(line -> line.contains("Bad is undefined"));
    assertThat(prove.out()).contains(told);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          the(o) in s, n = 0 | the(none)
          n = m(i) - 1 | negative
          """)
  void conditionIsUndefinedForCheckAndProve(String condition, String told) throws IOException {
    Path file = source(condition, "n := n", "");
    Cli check = Cli.run("check", file.toString(), "--robots", "2");
    Cli prove = Cli.run("prove", file.toString());
    assertThat(check.status()).as("%s", check).isEqualTo(ExitStatus.VIOLATED);
    assertThat(prove.status()).as("%s", prove).isEqualTo(ExitStatus.VIOLATED);
    assertThat(prove.out()).anyMatch(line -> line.contains(told));
  }

  @ParameterizedTest
  @CsvSource({"the(o) = i", "n = m(i) - 1"})
  void startIsUndefinedForCheckAndProve(String condition) throws IOException {
    Path file = source("n > 0", "n := n", "");
    String text = Files.readString(file);
    Files.writeString(
        file, text.replace("lock.start?\n", "lock.start?, forall i: P :: " + condition + "\n"));
    Cli check = Cli.run("check", file.toString(), "--robots", "2");
    Cli prove = Cli.run("prove", file.toString());
    assertThat(check.status()).as("%s", check).isEqualTo(ExitStatus.VIOLATED);
    assertThat(prove.status()).as("%s", prove).isEqualTo(ExitStatus.VIOLATED);
    assertThat(check.out()).contains("A (P 2): the start is undefined");
    assertThat(prove.out()).anyMatch(line -> line.startsWith("A: start "));
  }
}
