package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.cli.command.ExitStatus;

/** What was not looked at is not said to hold. */
class VerdictTest {

  @TempDir private Path folder;

  /** A counter; {@code inc} and {@code trip} have the conditions that are given. */
  private Path source(String parameters, String inc, String trip, String more) throws IOException {
    String text =
        """
        automaton C%s
        state
          c: nat
          bad: bool
        start c = 0, not bad
        action inc
          pre %s
          eff c := c + 1
        action trip
          pre %s
          eff bad := true
        invariant NotBad: not bad
        %s
        """
            .formatted(parameters, inc, trip, more);
    return Files.writeString(folder.resolve("c.starl"), text);
  }

  private static void hasVerdict(Cli cli, int status, String headline) {
    assertThat(cli.status()).as("%s", cli).isEqualTo(status);
    assertThat(cli.out().getFirst()).contains(headline);
    if (status == ExitStatus.NOT_DECIDED) {
      assertThat(cli.out()).noneMatch(line -> line.matches(".*\\bholds?\\b.*"));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          c < 2 | false | 0 | NotBad holds; never happens: trip
          c < 2 | c = 2, exists n: nat :: n > c | 1 | NotBad is false after 3 steps
          c < 2 | c = 2, not (forall n: nat :: n <= c) | 1 | NotBad is false after 3 steps
          c < 2 | c = 2, forall n: nat :: n <= c | 0 | NotBad holds; never happens: trip
          c < 2 | c in {3, 4} | 4 | not decided: steps are not taken
          c < 2 | exists n: nat :: n = c + 1 | 1 | NotBad is false after 1 step
          true | false | 4 | not decided: steps are not taken
          """)
  void quantifierOverNaturalsIsDecidedOrCounted(
      String inc, String trip, int status, String headline) throws IOException {
    Path file = source("", inc, trip, "");
    hasVerdict(Cli.run("check", file.toString()), status, headline);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          exists n: nat :: n > c | 0 | NotBad, More hold
          forall n: nat :: n >= c or n < c | 0 | NotBad, More hold
          forall n: nat :: exists k: nat :: k > n | 4 | not decided: conditions are not evaluated
          forall n: nat :: n < c or n + 1 > c | 0 | NotBad, More hold
          forall n: nat :: n < 3 | 1 | More is false after 0 steps
          forall n: nat :: n <= c => n < 3 | 0 | NotBad, More hold
          exists l: list[nat] :: l != [] and head(l) > c | 4 | not decided: conditions are not evaluated
          forall t: time :: t <= c or t > c | 4 | not decided: conditions are not evaluated
          exists o: option[nat] :: o != none and the(o) > c | 0 | NotBad, More hold
          exists o: option[nat] :: the(o) > c | 1 | More is undefined
          """)
  void invariantOverNaturalsIsDecidedOrCounted(String more, int status, String headline)
      throws IOException {
    Path file = source("", "c < 2", "false", "invariant More: " + more);
    hasVerdict(Cli.run("check", file.toString()), status, headline);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          trip(n: nat) | n > c | eff bad := true | 1 | NotBad is false after 1 step
          trip(n: nat) | c = 2, n > c | eff bad := true | 1 | NotBad is false after 3 steps
          set(n: nat) | n <= c | eff c := n | 0 | NotBad holds
          set(n: nat) | n > c | eff c := n | 4 | not decided: steps are not taken
          dt(d: time) | d <= 1 | | 4 | not decided: values are not tried
          """)
  void argumentBeyondTheBoundIsTriedOrCounted(
      String action, String pre, String eff, int status, String headline) throws IOException {
    String more = "action " + action + " pre " + pre + " " + (eff == null ? "" : eff);
    Path file = source("", "c < 2", "false", more.replace("trip(", "trip_it("));
    hasVerdict(Cli.run("check", file.toString()), status, headline);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          [n: nat] | assume A: n > 3, assume B: n < 2 | | 4 | not decided: THERE IS NO START STATE
          [n: nat] | assume A: n > 3 | | 4 | not decided: THERE IS NO START STATE
          [n: nat] | assume A: n > 3 | --nat=4 | 0 | C (n to --nat 4, --time 2): 3 states
          [n: nat] | assume A: n <= 1 | | 0 | C: 6 states
          | state m: [nat -> [nat -> set[nat]]] | | 4 | not decided: values are not tried
          | state k: nat | | 4 | not decided: values are not tried
          | | --most=2 | 4 | not decided: THE SEARCH DID NOT END
          """)
  void whatWasNotExploredIsNotDecided(
      String parameters, String more, String option, int status, String headline)
      throws IOException {
    Path file =
        source(
            parameters == null ? "" : parameters,
            "c < 2",
            "false",
            more == null ? "" : more.replace(", ", "\n"));
    Cli cli =
        option == null
            ? Cli.run("check", file.toString())
            : Cli.run("check", file.toString(), option);
    hasVerdict(cli, status, headline);
  }

  @ParameterizedTest
  @CsvSource({"7, count once: P", "8, too many orders of P"})
  void symmetryThatIsNotWholeIsTold(int robots, String told) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("ring.starl"),
            """
            automaton Ring[P]
            state
              next: [P -> option[P]]
              first: option[P]
              last: option[P]
              isClosed: bool
            start first = none, last = none, not isClosed, forall p: P :: next(p) = none
            action begin(p: P)
              pre first = none, not isClosed
              eff first := some(p), last := some(p)
            action add(p: P)
              pre last != none, next(p) = none, last != some(p)
              eff next(the(last)) := some(p), last := some(p)
            action close
              pre last != none, forall p: P :: next(p) != none or last = some(p)
              eff next(the(last)) := first, first := none, last := none, isClosed := true
            """);
    Cli cli = Cli.run("check", file.toString(), "--robots", "" + robots);
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).anyMatch(line -> line.endsWith(told));
    assertThat(cli.out().getFirst()).contains("%d states".formatted(robots + 2));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          fair | 0 | NotBad, Full hold
          | 1 | Full is false: nothing more happens after 0 steps
          """)
  void progressIsDecidedByCheckAndNotLookedAtElsewhere(String fair, int status, String headline)
      throws IOException {
    String text =
        Files.readString(
                source(
                    "", "c < 2", "c = 0", "constraint Low: c < 9 progress Full: eventually c = 2"))
            .replace("bad := true", "bad := false");
    Path file = folder.resolve("p.starl");
    Files.writeString(file, text.replace("action inc", "action inc " + (fair == null ? "" : fair)));
    hasVerdict(Cli.run("check", file.toString()), status, headline);
    Cli cli = Cli.run("compile", file.toString(), "--pvs", folder.toString());
    assertThat(cli.out())
        .contains("C: not in Java and PVS, see 'starl check': progress Full, constraint Low");
    assertThat(Files.readString(folder.resolve("C.pvs")))
        .contains("progress: Full; constraint: Low");
    Cli prove = Cli.run("prove", file.toString());
    assertThat(prove.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(prove.out())
        .contains(
            "C: Low bounds 'starl check' alone: what is proved is so of all states",
            "C: Full is not looked at: 'starl check' asks for progress",
            "C: not decided: Full");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          up is add | 0 | NotBad, refinement total hold | total holds
          up is nothing | 1 | refinement total is false after 1 step | total is not kept by up
          """)
  void refinementIsDecidedByCheckAndProveAndIsATheorem(
      String step, int status, String headline, String proof) throws IOException {
    Path file = folder.resolve("r.starl");
    Files.writeString(
        file,
        """
        automaton Total state n: nat start n = 0 action add pre n < 2 eff n := n + 1
        automaton C java "a.CAutomaton" state c: nat start c = 0
        refines total: Total by n := c, %s
        action up pre c < 2 eff c := c + 1
        invariant NotBad: c <= 2
        """
            .formatted(step));
    Cli check = Cli.run("check", file.toString());
    assertThat(check.status()).isEqualTo(status);
    assertThat(check.out()).anyMatch(line -> line.endsWith(headline));
    Cli prove = Cli.run("prove", file.toString());
    assertThat(prove.status()).isEqualTo(status);
    assertThat(prove.out()).contains("C: refinement " + proof);
    String to = folder.toString();
    Cli cli = Cli.run("compile", file.toString(), "--pvs", to);
    assertThat(cli.out()).noneMatch(line -> line.contains("refinement"));
    assertThat(Files.readString(folder.resolve("C.pvs"))).contains("total_up: THEOREM");
    Files.writeString(
        file,
        Files.readString(file)
            .replace("automaton Total", "automaton Total java \"a.TotalAutomaton\""));
    cli = Cli.run("compile", file.toString(), "--java", to);
    assertThat(cli.out()).contains("C: not in Java, see 'starl check': refinement total");
  }
}
