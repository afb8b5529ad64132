package org.starl.cli.lang;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;

/** {@code starl check}. */
class CheckTest {

  private static final String LAMPS =
      """
      automaton Lamps[PIDS, Rooms, first: set[PIDS]]
      state
        by: [Rooms -> option[PIDS]]
        n: nat
      start n = 0, forall r: Rooms :: by(r) = none
      action take(i: PIDS, r: Rooms)
        pre by(r) = none, i in first
        eff by(r) := some(i), n := n + 1
      action drop(r: Rooms)
        pre by(r) != none
        eff by(r) := none, n := n - 1
      invariant Counted: n = 0 <=> (forall r: Rooms :: by(r) = none)
      """;

  private static final String RING =
      """
      automaton Ring[N: nat]
      assume Some: N > 0
      state turn: 0..N-1
      start turn = 0
      action pass eff turn := (turn + 1) mod N
      """;

  /** It has 1 + 2 + 4 states with at most two in the line, and 8 with three. */
  private static final String LINE =
      """
      automaton Line
      state line: list[0..1]
      start line = []
      constraint Short: length(line) <= 2
      action join(k: 0..1) eff line := line ++ [k]
      action leave pre line != [] eff line := tail(line)
      invariant Few: length(line) <= 3
      """;

  /** Registers twice under one id. */
  static final String TWICE =
      """
      program Twice
      given xid: Text, acceptors: set[PIDS]
      uses reg: Registration(xid, acceptors)
      location first
        do reg.do_register(); goto second
      location second
        do reg.do_register(); goto first
      """;

  @TempDir private Path folder;

  private Cli check(String text, String... options) throws IOException {
    Path file = Files.writeString(folder.resolve("lamps.starl"), text);
    String[] args = new String[options.length + 2];
    args[0] = "check";
    args[1] = file.toString();
    System.arraycopy(options, 0, args, 2, options.length);
    return Cli.run(args);
  }

  @Test
  void everyStateIsVisited() throws IOException {
    Cli cli = check(LAMPS, "--robots", "2", "--no-symmetry", "--value", "first={bot0, bot1}");
    assertThat(cli.status()).as("%s", cli).isZero();
    // Each of two rooms has nobody, or one of two.
    assertThat(cli.out())
        .containsExactly(
            "Lamps (PIDS 2, Rooms 2): 9 states, 24 steps, at most 2 steps from a start; Counted holds",
            "  never false: 'i in first' of take");
    assertThat(cli.err()).singleElement().asString().endsWith("states a second");
    Cli symmetric = check(LAMPS, "--robots", "2", "--value", "first={bot0, bot1}");
    assertThat(symmetric.out())
        .containsExactly(
            "Lamps (PIDS 2, Rooms 2): 4 states, 11 steps, at most 2 steps from a start; Counted holds",
            "  states that differ in the names of elements alone count once: PIDS, Rooms",
            "  never false: 'i in first' of take");
  }

  @Test
  void parameterInTheBoundsOfARangeIsASize() throws IOException {
    Cli cli = check(RING);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out())
        .containsExactly(
            "Ring (N 1): 1 state, 1 step, at most 0 steps from a start; it has no invariant",
            "Ring (N 2): 2 states, 2 steps, at most 1 step from a start; it has no invariant");
    assertThat(check(RING, "--value", "N=5").out())
        .containsExactly(
            "Ring (N 5): 5 states, 5 steps, at most 4 steps from a start; it has no invariant");
    String[] both = {"--robots", "1", "--value", "first={bot0}", "--value", "N=3"};
    assertThat(check(LAMPS + RING, both).out())
        .anyMatch(line -> line.startsWith("Lamps (PIDS 1, Rooms 2): 3 states"))
        .anyMatch(line -> line.startsWith("Ring (N 3): 3 states"));
    assertThat(check(RING, "--value", "N=x").err())
        .singleElement()
        .asString()
        .isEqualTo("starl: --value N: 'x': expected a whole number from 0 to 1000");
    Cli none = check(RING, "--nat", "0");
    assertThat(none.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(none.out())
        .containsExactly(
            "Ring: not decided: no numbers to --nat 0 meet the assumptions; give larger ones: --value N=...");
    Cli empty = check(RING.replace("N > 0", "N >= 0"));
    assertThat(empty.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(empty.out())
        .startsWith(
            "Ring (N 0): the start is undefined",
            "  " + folder.resolve("lamps.starl") + ":3:13: the range 0..-1 is empty");
  }

  @Test
  void noStepIsTakenFromWhereAConstraintIsFalse() throws IOException {
    Cli cli = check(LINE, "--nat", "3");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out())
        .containsExactly(
            "Line: 7 states, 20 steps, at most 3 steps from a start; Few holds within Short",
            "  8 states outside, whose steps are not looked at");
    String file = folder.resolve("line.saved").toString();
    check(LINE, "--nat", "3", "--most", "9", "--checkpoint", file);
    assertThat(check(LINE, "--nat", "3", "--checkpoint", file, "--resume").out())
        .isEqualTo(cli.out());

    Cli outside = check(LINE.replace("<= 3", "<= 2"), "--nat", "3");
    assertThat(outside.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(outside.out()).first().isEqualTo("Line: Few is false after 3 steps");

    Cli bounds = check(LINE); // a list of three is beyond --nat 2
    assertThat(bounds.status()).isEqualTo(ExitStatus.NOT_DECIDED);

    Cli none = check(LINE.replace("<= 2", "= 1"));
    assertThat(none.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(none.out())
        .first()
        .asString()
        .contains("not decided: NO START STATE SATISFIES THE CONSTRAINTS");
  }

  @Test
  void aConstraintThatIsNeverFalseIsNamedAndProgressBeyondOneIsNotDecided() throws IOException {
    String closed = LINE.replace("eff line := line ++", "pre length(line) < 2 eff line := line ++");
    Cli cli = check(closed);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out())
        .containsExactly(
            "Line: 7 states, 12 steps, at most 2 steps from a start; Few holds",
            "  never false: constraint Short");
    String leaves = "progress Leaves: line = [1] leads to line != [1]\n";
    String fair = LINE.replace("action leave", "action leave fair") + leaves;
    assertThat(check(closed.replace("action leave", "action leave fair") + leaves).status())
        .isZero();
    Cli progress = check(fair, "--nat", "3");
    assertThat(progress.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(progress.out())
        .first()
        .asString()
        .contains("not decided: progress of runs that leave the constraints");
  }

  @Test
  void branchesOfAProgramAreToldWithTheirPlaces() throws IOException {
    Cli cli = check(TWICE, "--robots", "1");
    String file = folder.resolve("lamps.starl").toString();
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.out())
        .containsSubsequence(
            "Twice (PIDS 1): second_may_do_register is false after 1 step",
            "  "
                + file
                + ":7:6: false for self = bot0: reg.do_register(bot0) is not enabled:"
                + " 'not i in asked' is false",
            "  first_to_second is at " + file + ":5:3");
  }

  @Test
  void parameterOfTooManyValuesIsToldWithItsOption() throws IOException {
    Cli cli = check(LAMPS, "--robots", "30");
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err())
        .singleElement()
        .asString()
        .endsWith(
            "lamps.starl: Lamps: value parameter 'first': more than 100,000 values at these sizes;"
                + " give one: --value 'first=...', of type set[PIDS]");
  }

  @Test
  void violationIsToldAsARun() throws IOException {
    Cli cli = check(LAMPS.replace("n := n + 1", "n := 1"), "--robots", "2");
    assertThat(cli.status()).isOne();
    assertThat(cli.out())
        .startsWith(
            "Lamps (PIDS 2, Rooms 2): Counted is false after 3 steps",
            "  0. start   first = {bot0}",
            "  1. take(bot0, A)   by(A): none -> some(bot0), n: 0 -> 1",
            "  2. take(bot0, B)   by(B): none -> some(bot0)",
            "  3. drop(A)   by(A): some(bot0) -> none, n: 1 -> 0",
            "  " + folder.resolve("lamps.starl") + ":12:20: false");
  }

  @Test
  void errorsOfTheSourceAreLines() throws IOException {
    Cli cli = check(LAMPS.replace("some(i)", "some(j)").replace("n - 1", "m - 1"));
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.out()).isEmpty();
    assertThat(cli.err()).hasSize(2).allMatch(line -> line.contains("lamps.starl:"));
  }

  @Test
  void searchThatDoesNotEndIsNotWrong() throws IOException {
    Cli cli = check(LAMPS, "--most", "3");
    assertThat(cli.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(cli.out().getFirst())
        .endsWith("not decided: THE SEARCH DID NOT END; nothing is wrong so far");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --robots=0 | --robots: '0': expected a whole number from 1 to 62
          --size=Room=2 | --size: 'Room' is no opaque type here; expected one of PIDS, Rooms
          --size=Rooms | --size: 'Rooms': expected TYPE=N
          --size=first=2 | --size: 'first' is no opaque type here; expected --value first=2
          --size=Rooms=none | --size: 'none': expected a whole number from 1 to 62
          --size=Rooms=2 --size=Rooms=3 | --size Rooms: expected it once
          --value=first={} --value=first={bot0} | --value first: expected it once
          --nat=-1 | --nat: '-1': expected a whole number from 0 to 1000
          --value=last={} | --value: 'last' is no value parameter of Lamps; expected one of [first]
          --value=first={A} | --value first:1:2: 'A' is of type Rooms; expected PIDS
          """)
  void badOptionIsRefused(String option, String told) throws IOException {
    Cli cli = check(LAMPS, option.split(" "));
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).singleElement().asString().isEqualTo("starl: " + told);
  }

  @Test
  void whatIsNoSourceIsRefused() throws IOException {
    Path binary = Files.write(folder.resolve("binary.starl"), new byte[] {0, 1, (byte) 0xff});
    for (Path file : new Path[] {folder, folder.resolve("none.starl"), binary}) {
      Cli cli = Cli.run("check", file.toString());
      assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
      assertThat(cli.err())
          .singleElement()
          .asString()
          .startsWith("starl: " + file)
          .endsWith("; expected a source of automata (.starl)");
    }
    assertThat(check("").err())
        .singleElement()
        .asString()
        .contains("lamps.starl:1:1: no automaton or program here");
  }

  @Test
  void searchGoesOnWhereItEnded() throws IOException {
    String file = folder.resolve("lamps.search").toString();
    String[] command = {"--checkpoint", file, "--resume"};
    Cli first = check(LAMPS, "--checkpoint", file, "--most", "6");
    assertThat(first.status()).isEqualTo(ExitStatus.NOT_DECIDED);
    assertThat(first.err())
        .contains(file + ": the search is saved; the same command with --resume goes on");
    assertThat(check(LAMPS, command).err()).contains(file + ": goes on with 6 states");
    assertThat(check(LAMPS, command).out()).isEqualTo(check(LAMPS).out());
    assertThat(folder).isDirectoryNotContaining(path -> path.toString().endsWith(".part"));
  }

  @Test
  void savedSearchOfAnotherIsRefused() throws IOException {
    String file = folder.resolve("lamps.search").toString();
    check(LAMPS, "--checkpoint", file, "--most", "6");
    byte[] saved = Files.readAllBytes(Path.of(file));
    assertRefused(check(LAMPS, "--checkpoint", file), "exists already; expected --resume, or");
    assertRefused(check(LAMPS, "--resume"), "--resume needs --checkpoint FILE");
    String[] command = {"--checkpoint", file, "--resume"};
    assertRefused(
        check(LAMPS, "--checkpoint", file, "--resume", "--nat", "3"),
        "is a search of Lamps (PIDS 3, Rooms 2), --nat 2, --time 2, StarL ");
    assertRefused(
        check(LAMPS.replace("n + 1", "n + 0"), command), "expected one of Lamps (PIDS 3, Rooms 2)");
    assertRefused(
        check(RING, "--checkpoint", folder.resolve("ring").toString()),
        "has 2 searches, one for each automaton and value of sizes; expected one");
    assertThat(Path.of(file)).hasBinaryContent(saved);
    Files.write(Path.of(file), Arrays.copyOf(saved, saved.length - 9));
    assertRefused(check(LAMPS, command), "is incomplete or damaged (");
    Files.writeString(Path.of(file), "a note");
    assertRefused(check(LAMPS, command), "expected a file of 'starl check --checkpoint'");
    assertThat(Path.of(file)).hasContent("a note");
  }

  @Test
  void robotsAreCheckedThoughNoTypeHasThem() throws IOException {
    assertRefused(check(RING, "--robots", "99"), "--robots: '99': expected");
  }

  private static void assertRefused(Cli cli, String line) {
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).singleElement().asString().contains(line);
  }
}
