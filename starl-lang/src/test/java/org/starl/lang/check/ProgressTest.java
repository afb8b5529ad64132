package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type.Field;
import org.starl.lang.verdict.Verdict;

class ProgressTest {

  private static String model(String name) throws IOException {
    return Files.readString(Path.of("src/test/resources/progress/" + name + ".starl"));
  }

  /** The lines of the report, for sizes such as {@code PIDS=3 nat=2} and values {@code last=2}. */
  private static List<String> lines(String text, String sizes) throws SourceErrors {
    return check(text, sizes, 1_000_000, new Verdict[1]);
  }

  private static List<String> check(String text, String sizes, int most, Verdict[] verdict)
      throws SourceErrors {
    Automaton automaton = new SourceReader().read("x.starl", text).getLast();
    Map<String, String> given = new LinkedHashMap<>();
    for (String each : sizes.isEmpty() ? new String[0] : sizes.split(" ")) {
      given.put(each.split("=")[0], each.split("=")[1]);
    }
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton)
        .forEach(type -> opaque.put(type, Integer.parseInt(given.getOrDefault(type, "2"))));
    Sizes of = new Sizes(opaque, Integer.parseInt(given.getOrDefault("nat", "2")), 2);
    Machine machine = new Machine(automaton, of);
    Map<String, Object> values = new LinkedHashMap<>();
    for (Field field : machine.parameters()) {
      if (given.containsKey(field.name())) {
        Expr value =
            SourceReader.readExpression(
                automaton, List.of(), field.type(), "value", given.get(field.name()));
        values.put(field.name(), machine.value(value));
      }
    }
    Search.Result result = new Search(machine, of, values, true, most).run();
    verdict[0] = result.verdict();
    return Report.lines(automaton, of, result, name -> name);
  }

  private static String headline(String text, String sizes) throws SourceErrors {
    return lines(text, sizes).getFirst();
  }

  @Test
  void philosophersWithACircularWaitComeToADeadlock() throws IOException, SourceErrors {
    assertThat(lines(model("Dining"), "last=2 ordered=false"))
        .startsWith(
            "Dining: Goes_on is false: nothing can happen after 6 steps",
            "  0. start   last = 2, ordered = false")
        .contains("  Dining:40:19: false");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          takes1 and takes2 | strongly fair | strongly fair | holds
          takes1            | strongly fair | fair          | false
          takes2            | fair          | strongly fair | false
          none              | fair          | fair          | false
          """)
  void philosophersWhoTakeForksInOrderEatUnderStrongFairness(
      String strong, String takes1, String takes2, String verdict)
      throws IOException, SourceErrors {
    String text =
        model("Dining")
            .replaceFirst("takes1\\(p: nat\\)\n  strongly fair", "takes1(p: nat)\n  " + takes1)
            .replaceFirst("takes2\\(p: nat\\)\n  strongly fair", "takes2(p: nat)\n  " + takes2);
    String headline = headline(text, "last=2 ordered=true");
    assertThat(headline)
        .contains(verdict.equals("holds") ? "; Apart, Goes_on, Eats hold" : "Eats is false: ");
  }

  @Test
  void readersAndWritersAreServed() throws IOException, SourceErrors {
    assertThat(headline(model("ReadersWriters"), "Actors=2 nat=4"))
        .endsWith("Reads, Writes, Stops hold");
    String unfair = model("ReadersWriters").replace("  fair for any\n", "");
    assertThat(headline(unfair, "Actors=2 nat=4")).contains("is false: ");
  }

  @Test
  void allocatorServesEachClientUnderStrongFairness() throws IOException, SourceErrors {
    String text = model("SimpleAllocator");
    assertThat(lines(text, "Clients=3"))
        .startsWith(
            "SimpleAllocator (Clients 3, Resources 2): 400 states, 2,064 steps, at most 5 steps from"
                + " a start; Mutex, Clients_return, Clients_obtain, Again_satisfied hold")
        .contains(
            "  progress is of runs that may stop where nothing fair is possible; fair: give_all;"
                + " strongly fair: allocate");
    assertThat(headline(text.replace("strongly fair", "fair"), "Clients=3"))
        .contains("Clients_obtain is false: ");
    String keeps = text.replace("pre alloc(c) != {}", "pre unsat(c) = {}, alloc(c) != {}");
    assertThat(lines(keeps, "Clients=3"))
        .containsSequence(
            "SimpleAllocator (Clients 3, Resources 2): Clients_obtain is false: nothing more happens"
                + " after 4 steps",
            "  1. request(bot0, {A, B})   unsat(bot0): {} -> {A, B}",
            "  2. request(bot1, {A, B})   unsat(bot1): {} -> {A, B}",
            "  3. allocate(bot0, {B})   unsat(bot0): {A, B} -> {A}, alloc(bot0): {} -> {B}",
            "  4. allocate(bot1, {A})   unsat(bot1): {A, B} -> {B}, alloc(bot1): {} -> {A}",
            "  then nothing more happens");
  }

  @Test
  void ringElectsALeader() throws IOException, SourceErrors {
    assertThat(headline(model("ChangRoberts"), "last=2"))
        .contains("137 states")
        .endsWith("Ends, Elected hold");
    String unfair = model("ChangRoberts").replaceAll("  fair as node for n\n", "");
    assertThat(headline(unfair, "last=2"))
        .endsWith("Elected is false: nothing more happens after 0 steps");
    String lossy = model("ChangRoberts").replace("union {id}", "");
    assertThat(headline(lossy, "last=2")).contains("Elected is false: ");
  }

  @Test
  void terminationIsDetected() throws IOException, SourceErrors {
    assertThat(headline(model("Termination"), "")).endsWith("Sound, Ends, Detects hold");
    String stays =
        model("Termination").replace("token = black or color(0) = black", "token = black");
    assertThat(headline(stays, "")).contains("is false: ");
  }

  @Test
  void mutexGrantsEachRequestIfEachHolderReleases() throws IOException, SourceErrors {
    String text = model("MutexProgress");
    assertThat(lines(text, "PIDS=3"))
        .anyMatch(line -> line.endsWith("; assumed: Releases, Comes_free; strongly fair: od_mutex"))
        .first()
        .asString()
        .endsWith("; Granted holds");
    String turns = text.replaceFirst("assume progress Comes_free:\n.*\n", "");
    assertThat(headline(turns, "PIDS=3 Zones=1")).endsWith("; Granted holds");
    assertThat(lines(turns, "PIDS=3"))
        .startsWith(
            "MutexProgress (PIDS 3, Zones 2): Granted is false: 6 steps come round for ever after 3"
                + " steps")
        .contains("  then again and again:");
    String selfish = turns.replaceFirst("assume progress.*\n", "");
    assertThat(headline(selfish, "PIDS=3 Zones=1"))
        .endsWith("Granted is false: nothing more happens after 3 steps");
    assertThat(headline(text.replace("strongly fair", "fair"), "PIDS=3"))
        .contains("Granted is false: ");
  }

  // --- what the words mean

  /** A counter to 3 that may be set back to 0 once, and a lamp. */
  private static String counter(String inc, String more) {
    return """
    automaton Counter
    state
      c: nat
      set_back: bool
      on: bool
    start c = 0, not set_back, not on
    action inc %s
      pre c < 2 eff c := c + 1
    action back
      pre c = 2, not set_back eff c := 0, set_back := true
    action switch fair
      eff on := not on
    %s
    """
        .formatted(inc, more);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          fair | eventually c = 2 | P holds
          | eventually c = 2 | P is false: 2 steps come round for ever after 0 steps
          fair | eventually c = 2 and set_back | P is false: 2 steps come round for ever after 2 steps
          fair | c = 0 leads to c = 2 | P holds
          fair | set_back leads to c = 2 | P holds
          fair | c = 2 leads to c = 1 | P is false: 2 steps come round for ever after 2 steps
          fair | true leads to on | P holds
          fair | true leads to not on | P holds
          fair | c = 1 leads to c = 0 | P is false: 2 steps come round for ever after 2 steps
          fair | c = 5 leads to c = 0 | P holds; never happens: the left side of P
          fair | forall k: nat :: k <= 2 leads to c = k | P is false: 2 steps come round for ever
          fair | forall k: nat :: c < k and k <= 2 leads to c >= k | P holds
          fair | no deadlock | P holds
          """)
  void whatIsToHappenIsAskedOfAllFairRuns(String inc, String formula, String told)
      throws SourceErrors {
    String text = counter(inc == null ? "" : inc, "progress P: " + formula);
    assertThat(headline(text, "")).contains(told);
  }

  @Test
  void storyTellsWhichFairActionsAreTaken() throws SourceErrors {
    String more = "action hop fair pre on, c = 0 eff c := 1\nprogress P: c = 0 leads to c = 2";
    assertThat(lines(counter("", more), ""))
        .containsExactly(
            "Counter: P is false: 2 steps come round for ever after 0 steps",
            "  then again and again:",
            "  1. switch()   on: false -> true",
            "  2. switch()   on: true -> false",
            "  fair, and taken there: switch()",
            "  fair, and possible there at times, but not all the time: hop()",
            "  Counter:14:1: P(): the left side holds after 0 steps, and the right side never then",
            "  progress is of runs that may stop where nothing fair is possible; fair: switch, hop",
            "  states that differ in the names of elements alone count each, for progress");
  }

  @Test
  void whatWasNotVisitedIsNotDecided() throws SourceErrors {
    Verdict[] verdict = new Verdict[1];
    String text = counter("fair", "progress P: eventually c = 2 and set_back");
    assertThat(check(text, "", 3, verdict).getFirst()).contains("THE SEARCH DID NOT END");
    assertThat(verdict[0]).isEqualTo(Verdict.NOT_DECIDED);
    String large = text.replace("c < 2", "c < 5").replace("c = 2", "c = 5");
    assertThat(check(large, "", 1000, verdict).getFirst()).contains("steps are not taken");
    assertThat(verdict[0]).isEqualTo(Verdict.NOT_DECIDED);
    // A run that keeps to states of which all steps are known is one.
    String stays = large.replace("inc fair", "inc");
    assertThat(check(stays, "", 1000, verdict).getFirst()).contains("P is false: ");
    assertThat(verdict[0]).isEqualTo(Verdict.VIOLATED);
  }

  @Test
  void whatIsAssumedLeavesRunsOut() throws SourceErrors {
    String claim = "\nprogress P: eventually c = 2";
    assertThat(headline(counter("", "assume progress A: c < 2 leads to c = 2" + claim), ""))
        .endsWith("P holds");
    assertThat(headline(counter("", "assume progress A: c < 2 leads to c = 1" + claim), ""))
        .contains("P is false: ");
    assertThat(headline(counter("", "assume progress A: true leads to c = 7" + claim), ""))
        .contains("not decided: NO RUN IS AS PROGRESS IS ASSUMED");
    // The only run that breaks it owes from its first step what is assumed.
    String owes = "assume progress A: c = 0 leads to set_back\nprogress P: eventually set_back";
    assertThat(headline(counter("", owes), ""))
        .contains("not decided: P is broken by a run that leaves open what is assumed");
  }

  /** From the start where it does not work, the only run without success owes what is assumed. */
  @Test
  void runThatLeavesOpenWhatIsAssumedHidesNoOtherFromAnotherStart() throws SourceErrors {
    String tries =
        """
        automaton Tries[works: bool]
        state
          sent: bool
          failed: bool
          on: bool
        start not sent, not failed, not on
        action send fair pre not sent, not failed eff sent := true
        action arrive fair pre sent, works eff on := true
        action fail pre sent, not on eff sent := false, failed := true
        assume progress A: sent leads to sent and works
        progress P: eventually on
        """;
    assertThat(lines(tries, ""))
        .startsWith(
            "Tries: P is false: nothing more happens after 2 steps", "  0. start   works = true");
    String lazy = tries.replace("fair pre not sent", "fair pre not works, not sent");
    assertThat(headline(lazy.replace("eventually on", "not works leads to on"), ""))
        .contains("not decided: P is broken by a run that leaves open what is assumed;");
  }

  @Test
  void deadlockIsNoneWhereARunMayEnd() throws SourceErrors {
    String text = counter("", "").replaceFirst("action switch fair\n.*\n", "");
    String broken = text + "progress P: no deadlock";
    assertThat(lines(broken, ""))
        .startsWith("Counter: P is false: nothing can happen after 5 steps")
        .noneMatch(line -> line.contains("fair"));
    assertThat(headline(broken + " unless set_back", "")).endsWith("P holds");
    assertThat(headline(broken + " unless c = 0", "")).contains("P is false: ");
  }

  @Test
  void conditionWithoutValueIsTold() throws SourceErrors {
    assertThat(lines(counter("fair", "progress P: eventually c - 1 = 0"), ""))
        .startsWith("Counter: P is undefined after 0 steps")
        .contains("  Counter:13:24: 0 - 1 is below 0; expected a value of nat");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          fair for k | inc | eventually on | 7:21: 'k' is no parameter of 'inc'; expected some of [], or 'any'
          fair | it | forall k: nat :: no deadlock | 13:30: a deadlock is of the whole state; expected no 'forall'
          fair | it | exists k: nat :: c = k leads to on | 13:13: 'exists' reaches to 'leads to' here; expected parentheses around it
          fair | it | c leads to on | 13:13: 'c' is of type nat; expected bool
          fair | it | on | 14:1: found the end of the file; expected 'leads'
          """)
  void mistakeIsToldWithItsPlace(String inc, String group, String formula, String told) {
    String text = counter(inc, "progress P: " + formula);
    String both = text.replace("switch fair", "switch fair as " + group);
    assertThatThrownBy(() -> headline(both, "")).hasMessageContaining(told);
  }

  @Test
  void onlyLeadsToCanBeAssumed() {
    String text = counter("", "assume progress P: eventually on");
    assertThatThrownBy(() -> headline(text, ""))
        .hasMessageContaining("this cannot be assumed; expected 'P leads to Q'");
  }
}
