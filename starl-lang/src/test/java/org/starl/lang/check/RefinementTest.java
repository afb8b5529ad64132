package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.starl.lang.prove.Prover;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.verdict.Verdict;

/** That an automaton refines another one, in {@code starl check}. */
class RefinementTest {

  /** Counts to 2, and the abstract one in steps that it need not name. */
  private static final String COUNTERS =
      """
      automaton Total
      state n: nat
      start n = 0
      action add(k: nat)
        pre k > 0, n + k <= 2
        eff n := n + k
      automaton Parts[P]
      state
        at: [P -> nat]
      start forall p: P :: at(p) = 0
      fun sum: nat = card({p: P | at(p) = 1})
      refines total: Total by
        n := sum,
        up(p) is add(1)
      action up(p: P)
        pre at(p) = 0, sum < 2
        eff at(p) := 1
      action look(p: P)
        pre at(p) > 0
      """;

  private static Automaton read(String text) throws SourceErrors {
    return new SourceReader().read("x.starl", text).getLast();
  }

  private static Search.Result result(Automaton automaton, Sizes sizes, int most) {
    return new Search(new Machine(automaton, sizes), sizes, Map.of(), true, most).run();
  }

  private static Sizes sizes(Automaton automaton) {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, 2));
    return new Sizes(opaque, 2, 2);
  }

  private static List<String> lines(String text) throws SourceErrors {
    Automaton automaton = read(text);
    Sizes sizes = sizes(automaton);
    return Report.lines(
        automaton, sizes, result(automaton, sizes, 100_000), name -> name + ".starl");
  }

  private static String counters(String from, String to) {
    assertThat(COUNTERS).contains(from);
    return COUNTERS.replace(from, to);
  }

  @ParameterizedTest
  @CsvSource({
    "TwoPhase, 'Told, All_known, Was_prepared, Decided, refinement tc hold'",
    "LockServer, 'In_table, Apart, refinement mutex hold'",
    "Everybody, refinement group holds"
  })
  void modelRefinesItsSpecification(String name, String verdict) throws IOException, SourceErrors {
    Automaton automaton = new SourceReader().read(RefinementModels.file(name)).getLast();
    Sizes sizes = sizes(automaton);
    Search.Result result = result(automaton, sizes, 100_000);
    assertThat(Report.lines(automaton, sizes, result, of -> of).getFirst()).endsWith(verdict);
    assertThat(result.verdict()).isEqualTo(Verdict.HOLDS);
  }

  @Test
  void abstractStateAddsNoStates() throws IOException, SourceErrors {
    Automaton automaton = new SourceReader().read(RefinementModels.file("TwoPhase")).getLast();
    Sizes sizes = new Sizes(Map.of("RM", 3), 1, 1);
    Search.Result all =
        new Search(new Machine(automaton, sizes), sizes, Map.of(), false, 1000).run();
    assertThat(all.states()).isEqualTo(288); // as TLC tells
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = RefinementModels.MUTANTS)
  void mutantIsCaught(String name, String from, String to, String action)
      throws IOException, SourceErrors {
    Automaton automaton = RefinementModels.mutant(name, from, to);
    Search.Result result = result(automaton, sizes(automaton), 100_000);
    Finding finding = result.finding().orElseThrow();
    assertThat(finding.name()).startsWith("refinement ");
    assertThat(String.join("\n", finding.story()))
        .containsPattern(
            "[0-9]+\\. " + action + "\\([^\n]*\n[a-z]+ [^\n]*\nthe state maps to: [^\n]*$");
  }

  @Test
  void stepThatIsNotEnabledIsToldWithBothStates() throws SourceErrors {
    assertThat(lines(counters("add(1)", "add(3)")))
        .containsExactly(
            "Parts (P 2): refinement total is false after 1 step",
            "  1. up(bot0)   at(bot0): 0 -> 1",
            "  total cannot take add(3) in: n = 0",
            "  the state maps to: n = 1",
            "  Parts.starl:14:12: total.add(3) is not enabled: 'n + k <= 2' is false",
            "  states that differ in the names of elements alone count once: P");
  }

  @Test
  void otherStateIsToldWithBothStates() throws SourceErrors {
    assertThat(lines(counters("add(1)", "add(2)")))
        .startsWith(
            "Parts (P 2): refinement total is false after 1 step",
            "  1. up(bot0)   at(bot0): 0 -> 1, total.n: 0 -> 2",
            "  total takes add(2): n = 2",
            "  the state maps to: n = 1",
            "  Parts.starl:13:8: false");
    assertThat(lines(counters("up(p) is add(1)", "up(p) is nothing")))
        .contains("  total takes no step: n = 0", "  the state maps to: n = 1");
    assertThat(lines(counters("n := sum,\n  up(p) is add(1)", "n := sum")))
        .contains("  total takes no step: n = 0", "  the state maps to: n = 1");
    assertThat(lines(counters("  pre at(p) > 0", "  eff at(p) := 1")))
        .contains("  1. look(bot0)   at(bot0): 0 -> 1", "  total takes no step: n = 0");
  }

  @Test
  void startIsAStartOfTheAbstractOne() throws SourceErrors {
    assertThat(lines(counters("start n = 0", "start n = 1")))
        .startsWith(
            "Parts (P 2): refinement total is false after 0 steps",
            "  total starts in: n = 0",
            "  the state maps to: n = 0",
            "  Parts.starl:12:1: false: total is no start state of Total");
    assertThat(
            lines(
                counters("automaton Total", "automaton Total[m: nat] assume Low: m < 2")
                    .replace("Parts[P]", "Parts[P, m: nat]")
                    .replace("total: Total", "total: Total[m]")))
        .contains("Parts (P 2, m to --nat 2, --time 2): refinement total is false after 0 steps");
  }

  @Test
  void firstConditionThatHoldsChoosesTheStep() throws SourceErrors {
    String choice = "if at(p) = 1 then nothing else if sum = 0 then add(1) else add(1)";
    assertThat(lines(counters("add(1)", choice)).getFirst()).endsWith("refinement total holds");
    assertThat(lines(counters("add(1)", "if sum = 0 then add(1)")))
        .contains("  total takes no step: n = 1", "  the state maps to: n = 2");
  }

  @Test
  void twoAutomataAreRefined() throws SourceErrors {
    String two =
        counters("action up", "refines also: Total by n := sum, up(p) is add(1) action up");
    assertThat(lines(two).getFirst()).endsWith("refinement total, refinement also hold");
    assertThat(lines(two.replace("n := sum, up(p) is add(1)", "n := 0")).getFirst())
        .endsWith("refinement total, refinement also hold");
  }

  @Test
  void abstractStepsThatNoActionTakesAreNamed() throws IOException, SourceErrors {
    Automaton automaton = new SourceReader().read(RefinementModels.file("LockServer")).getLast();
    Sizes sizes = sizes(automaton);
    assertThat(Report.lines(automaton, sizes, result(automaton, sizes, 1000), of -> of))
        .contains("  never a step of mutex: withdraw, restart, take_over, stands_in");
    assertThat(lines(COUNTERS)).noneMatch(line -> line.contains("never a step"));
    assertThat(lines(counters("pre at(p) = 0,", "pre at(p) > 0,")))
        .contains("  never a step of total: add");
  }

  @Test
  void refinementIsNamedBesideManyInvariants() throws SourceErrors {
    StringBuilder text = new StringBuilder(COUNTERS);
    for (int i = 0; i < 9; i++) {
      text.append("invariant I").append(i).append(": sum <= 2\n");
    }
    assertThat(lines(text.toString()).getFirst())
        .endsWith("all 9 invariants and refinement total hold");
  }

  @Test
  void whatIsNotExploredDoesNotHold() throws SourceErrors {
    assertThat(lines(counters("at(p) = 0\n", "at(p) = 0 and at(p) = 1\n")).getFirst())
        .contains("not decided: THERE IS NO START STATE");
    Automaton automaton = read(COUNTERS);
    assertThat(result(automaton, sizes(automaton), 1).verdict()).isEqualTo(Verdict.NOT_DECIDED);
    assertThat(
            lines(
                    counters("n := sum", "n := sum + sum")
                        .replace("<= 2", "<= 4")
                        .replace("add(1)", "add(2)"))
                .getFirst())
        .contains("not decided: steps are not taken");
    String endless =
        counters("state n: nat", "state n: nat seen: [nat -> bool]")
            .replace("nat]\nstart", "nat] log: [nat -> bool]\nstart")
            .replace("n := sum", "n := sum, seen := log")
            .replace(
                "forall p: P :: at(p) = 0", "forall p: P :: at(p) = 0, forall k: nat :: not log(k)")
            .replace("start n = 0", "start n = 0, forall k: nat :: not seen(k)");
    assertThat(lines(endless).getFirst())
        .contains("not decided: conditions are not evaluated in some states");
  }

  @Test
  void mappingWithoutAValueIsUndefined() throws SourceErrors {
    assertThat(lines(counters("n := sum", "n := if sum < 2 then sum else 1 - sum")))
        .contains("Parts (P 2): refinement total is undefined after 2 steps");
  }

  @Test
  void exampleOfTheManualIsToldAsThere() throws IOException, SourceErrors {
    String manual = Files.readString(Path.of("../docs/language.md"));
    String text = manual.substring(manual.indexOf("// One robot at a time is at work."));
    text = text.substring(0, text.indexOf("```"));
    Automaton keys = read(text);
    Sizes sizes = new Sizes(Map.of("PIDS", 3), 2, 2);
    List<String> told = Report.lines(keys, sizes, result(keys, sizes, 1000), of -> "keys.starl");
    assertThat(manual).contains("    " + String.join("\n    ", told.subList(0, 7)) + "\n");
    Automaton right =
        read(
            text.replace("pre i in has\n  eff works", "pre i in has, not i in works\n  eff works"));
    assertThat(result(right, sizes, 1000).verdict()).isEqualTo(Verdict.HOLDS);
    List<String> proved =
        new Prover(right, 10_000_000, (title, script) -> {}).prove().lines("x.starl");
    assertThat(manual).contains("    " + String.join("\n    ", proved.subList(1, 3)) + "\n");
  }
}
