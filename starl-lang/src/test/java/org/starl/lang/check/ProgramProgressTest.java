package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type.Field;

/** Progress of programs, under what is assumed of their branches and primitives. */
class ProgramProgressTest {

  private static final int MOST_STATES = 3_000_000;
  private static final Pattern BLOCK = Pattern.compile("\n```\n(.*?)```", Pattern.DOTALL);

  private static Automaton read(String text) throws SourceErrors {
    return new SourceReader().read("x.starl", text).getLast();
  }

  /**
   * The lines of the report.
   *
   * @param values as text, of value parameters that are given
   */
  private static List<String> lines(
      String text, int robots, int places, int nat, Map<String, String> values)
      throws SourceErrors {
    Automaton automaton = read(text);
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, 1));
    opaque.put("PIDS", robots);
    opaque.replace("Places", places);
    Sizes sizes = new Sizes(opaque, nat, 2);
    Machine machine = new Machine(automaton, sizes);
    Map<String, Object> given = new LinkedHashMap<>();
    for (Field field : machine.parameters()) {
      String value = values.get(field.name());
      if (value != null) {
        given.put(
            field.name(),
            machine.value(
                SourceReader.readExpression(
                    automaton, machine.elements(), field.type(), "value", value)));
      }
    }
    Search.Result result = new Search(machine, sizes, given, true, MOST_STATES).run();
    return Report.lines(automaton, sizes, result, name -> name);
  }

  private static List<String> lines(String text, int robots, int places, int nat)
      throws SourceErrors {
    return lines(text, robots, places, nat, Map.of());
  }

  // --- a robot that visits a dock: the project of 'starl new --starl'

  private static String visits() throws IOException {
    Path project = Path.of("../starl-cli/src/main/resources/org/starl/cli/project/starl");
    return Files.readString(project.resolve("App.starl.txt"))
            .replace("@Name@", "Robots")
            .replace("@package@", "robots")
        + "progress Visits: forall i: PIDS :: loc(i) = ask leads to loc(i) = done\n";
  }

  @ParameterizedTest
  @CsvSource({"2, 1, 1, 160", "3, 1, 1, '1,180'"})
  void eachRobotMakesItsVisits(int robots, int places, int nat, String states)
      throws IOException, SourceErrors {
    assertThat(lines(visits(), robots, places, nat))
        .first()
        .asString()
        .contains(states + " states, ")
        .endsWith("; all 15 invariants and progress hold");
  }

  @Test
  @Tag("long")
  void eachRobotMakesItsVisitsToAnotherPlace() throws IOException, SourceErrors {
    assertThat(lines(visits(), 2, 2, 1)).first().asString().endsWith(" and progress hold");
    assertThat(lines(visits(), 3, 1, 2)).first().asString().endsWith(" and progress hold");
  }

  /** The program without its invariants: these find a wrong call before. */
  private static String wrong(String right, String wrong) throws IOException {
    String text = visits();
    assertThat(text).contains(right);
    return text.replace(right, wrong)
        .replaceAll("(?ms)^(// [^\n]*\n)?invariant .*?(?=^progress)", "");
  }

  @Test
  void forgottenReleaseIsToldAsAStory() throws IOException, SourceErrors {
    assertThat(lines(wrong("mux.release({dock}); ", ""), 2, 1, 1))
        .containsSubsequence(
            "  6. moat_arrived(bot1)   moat.motionflag(bot1): MOVING -> DONE",
            "  7. drive_out_to_ask(bot1)   loc(bot1): drive_out -> ask, made(bot1): 0 -> 1",
            "  8. ask_to_done(bot1)   loc(bot1): ask -> done",
            "  then again and again:",
            "  9. ask_to_wait(bot0)   loc(bot0): ask -> wait, mux.req_set(bot0): {} -> {A}",
            "  10. wait_to_ask(bot0)   loc(bot0): wait -> ask, mux.req_set(bot0): {A} -> {}",
            "  fair, and taken there: ask(bot0)")
        .first()
        .asString()
        .endsWith("Visits is false: 2 steps come round for ever after 8 steps");
  }

  /** From a start where nothing is near, a motion leaves open what is assumed of it. */
  @Test
  void failureThatNoBranchAsksForIsFoundFromAnotherStart() throws IOException, SourceErrors {
    String ends = "  when moat.failed do moat.do_move(place); goto drive_in\n";
    assertThat(lines(wrong(ends, ""), 2, 1, 1))
        .contains("  4. moat_failed(bot0)   moat.motionflag(bot0): MOVING -> FAIL")
        .first()
        .asString()
        .contains("Visits is false: ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          strongly fair for i | hold
          fair for i | is false
          '' | is false
          """)
  void grantsMustBeStronglyFairWhereRequestsMayFail(String fairness, String told)
      throws IOException, SourceErrors {
    String primitives =
        Files.readString(Path.of("src/main/resources/org/starl/lang/primitives.starl"));
    String mutex =
        primitives.substring(
            primitives.indexOf("primitive FixedMutex"), primitives.indexOf("// gvh"));
    assertThat(mutex).contains("do od_mutex strongly fair for i");
    String own = mutex.replace("strongly fair for i", fairness);
    assertThat(lines(own + visits(), 2, 1, 1)).first().asString().contains(told);
  }

  // --- what the words mean

  /** Lamps that change by themselves; a robot waits for its own. */
  private static String lamps(String branches, String progress) {
    return """
    automaton Lamps[PIDS]
    state red: set[PIDS]
    start red = {}
    action change(i: PIDS) eff red := if i in red then red minus {i} else red union {i}
    action burst(i: PIDS) eff red := red
    primitive Lamp is Lamps
    java "a.Lamp" = "new a.Lamp()"
    fun red: bool = self in red java "red()"
    when failed = burst(self) java "failed()"
    do change fair
    program Waits
    given goal: bool
    uses lamp: Lamp
    location wait
    %s
    location gone
    progress P: %s
    """
        .formatted(branches, progress);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          when lamp.red do goto gone | P is false: 2 steps come round for ever
          when lamp.red do goto gone when not lamp.red do goto gone | P holds
          when lamp.red do goto gone when lamp.failed do goto wait | P holds
          when lamp.failed do goto gone | P is false: 2 steps come round for ever
          when false do goto gone | P is false: 2 steps come round for ever
          do goto gone | P holds
          """)
  void processGoesOnWhereSomeGuardHoldsAtAllTimes(String location, String told)
      throws SourceErrors {
    String text = lamps(location, "forall i: PIDS :: loc(i) = wait leads to loc(i) = gone");
    assertThat(lines(text, 1, 1, 1)).first().asString().contains(told);
  }

  @Test
  void deadlockAndGivenValuesAreAskedOfAProgram() throws SourceErrors {
    String quiet = lamps("do goto gone", "no deadlock").replace("do change fair\n", "");
    assertThat(lines(quiet, 1, 1, 1))
        .first()
        .asString()
        .contains("P is false: nothing can happen after 1 step");
    assertThat(
            lines(
                quiet.replace("no deadlock", "no deadlock unless forall i: PIDS :: loc(i) = gone"),
                1,
                1,
                1))
        .first()
        .asString()
        .endsWith("P holds");
    // Nothing else reads what is given.
    assertThat(lines(lamps("do goto gone", "forall i: PIDS :: goal(i) leads to false"), 1, 1, 1))
        .first()
        .asString()
        .contains("P is false");
  }

  @Test
  void nothingIsFairWhereNoProgressIsAsked() throws SourceErrors {
    String text = lamps("do goto gone", "eventually true").replaceFirst("progress.*\n", "");
    assertThat(read(text).fairness()).isEmpty();
    assertThat(read(text + "assume progress Q: true leads to true").fairness())
        .containsExactly("assumed: Q", "fair: wait_to_gone, lamp_change");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          do change fair for k | 10:20: 'k' is no parameter of 'change'; expected some of [i], or 'any'
          assume progress Q: eventually true | 10:20: this cannot be assumed; expected 'P leads to Q'
          assume progress Q: forall i: PIDS :: i in rd leads to true | 10:43: 'rd' is not known here
          """)
  void mistakeInAPrimitiveIsToldWithItsPlace(String face, String told) {
    String text = lamps("do goto gone", "eventually true").replace("do change fair", face);
    assertThatThrownBy(() -> read(text)).hasMessageContaining("x.starl:" + told);
  }

  @Test
  void nameOfAnInvariantIsNoneOfProgress() {
    String text = lamps("do goto gone", "eventually true") + "invariant P: true";
    assertThatThrownBy(() -> read(text))
        .hasMessageContaining("'P' is an invariant already; expected a new name");
  }

  // --- the crossing of the manual, and the paper's car

  private static String manual() throws IOException {
    return Files.readString(Path.of("../docs/language.md"));
  }

  private static String block(String beginning) throws IOException {
    return BLOCK
        .matcher(manual())
        .results()
        .map(found -> found.group(1))
        .filter(text -> text.startsWith(beginning))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void carOfTheManualWhoseMotionFailsStandsOnTheBridge() throws IOException, SourceErrors {
    String crossing =
        block("// Cars cross a bridge")
                .replace("when reg.registered do", "when reg.registered and way != {} do")
            + block("// Only at these locations")
            + block("progress Gets_across");
    List<String> told = lines(crossing, 2, 1, 2);
    assertThat(manual()).contains("    " + told.getFirst() + "\n");
    int last = told.indexOf("  then nothing more happens");
    assertThat(manual()).contains(String.join("\n    ", told.subList(last - 2, last + 1)));
    assertThat(told.getFirst())
        .contains("Gets_across is false: nothing more happens after 9 steps");
    String right =
        crossing.replaceFirst("(?m)^  when moat.done .*\n", "$0" + block("  when moat.failed"));
    String first = lines(right, 2, 1, 2).getFirst();
    assertThat(manual()).contains("    " + first + "\n");
    assertThat(first).endsWith("not decided: steps are not taken; nothing is wrong so far");
  }

  /**
   * The paper's car, with a registration whose lists differ from those before them: its lists are
   * finitely many. A list as before tells no car anything.
   */
  private static String car() throws IOException {
    String primitives =
        Files.readString(Path.of("src/main/resources/org/starl/lang/primitives.starl"));
    String decides = "pre list(number) minus gone";
    String lists = Files.readString(Path.of("../pvs/starl/Registration_decls.starl"));
    String car = Files.readString(Path.of("../starl-apps/src/main/starl/IcpProgram.starl"));
    assertThat(lists).contains(decides);
    return lists
            .replace("Registration_decls[", "Registration_changes[")
            .replaceAll("(?m)^java .*\n", "")
            .replace(decides, "pre L != list(number), list(number) minus gone")
        + primitives
            .substring(
                primitives.indexOf("primitive Registration"),
                primitives.indexOf("// Over a registration"))
            .replace("Registration_decls", "Registration_changes")
        + car
        + """
        progress Passes: forall i: PIDS :: loc(i) = reg_wait leads to loc(i) = done or loc(i) = over
        assume progress Gets_out: forall i: PIDS :: loc(i) = S1 leads to car.atExit(i)
        """;
  }

  private static final Map<String, String> WAY = Map.of("way", "[t: Trip -> [A]]");

  @Test
  @Tag("long")
  void carOfThePaperGetsThrough() throws IOException, SourceErrors {
    // A list of zones that is longer than there are zones is not distinct: it is not tried.
    assertThat(lines(car(), 2, 1, 4, WAY))
        .contains(
            "  not each value is tried, but whole ones to --nat 4, --time 2: rest of car_look")
        .first()
        .asString()
        .contains("1,157,120 states")
        .contains("not decided: values are not tried; nothing is wrong so far");
  }

  @Test
  @Tag("long")
  void carOfThePaperThatWaitsForAWrongFlagIsFound() throws IOException, SourceErrors {
    String text = car().replace("when car.atExit do", "when car.ready do");
    assertThat(lines(text, 2, 1, 4, WAY))
        .contains("  fair, and possible there at times, but not all the time: S1(bot0)")
        .first()
        .asString()
        .contains("Passes is false: ");
  }
}
