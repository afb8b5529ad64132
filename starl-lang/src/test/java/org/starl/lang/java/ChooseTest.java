package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.lang.java.Sources.proved;
import static org.starl.lang.java.Sources.read;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.check.Search;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.verdict.Verdict;

/** {@code choose x: T :: a}: any value that satisfies the condition, of equal sets the same one. */
class ChooseTest {

  private static final String LEADER =
      """
      automaton Leader[T, V]
      java "x.XAutomaton"
      java T = "String"
      java V = "String"
      state
        live: set[T]
        copy: set[T]
        lead: option[T]
        top: nat
        seen: option[V]
      start live = {}, copy = {}, lead = none, top = 0, seen = none
      action join(t: T)
        pre not t in live
        eff live := live union {t}, copy := copy union {t}
      action elect
        pre live != {}
        eff lead := some(choose t: T :: t in live)
      action grow
        pre top < 2
        eff top := choose n: nat :: n in top..2 and n != top
      action same(n: nat)
        pre (choose k: nat :: k in n..2000) = (choose k: int :: k in n..2000 and k >= 0)
      action look(v: V)
        eff seen := some(v)
      """;

  /** The condition of the choice is satisfied by infinitely many numbers. */
  private static final String FRESH =
      """
      automaton Fresh[T]
      state
        used: set[nat]
        has: [T -> option[nat]]
      start used = {}, has = [t: T -> none]
      action take(t: T)
        pre has(t) = none, exists n: nat :: not n in used
        eff has(t) := some(choose n: nat :: not n in used),
          used := used union {choose n: nat :: not n in used}
      invariant Used: forall t: T :: has(t) != none => the(has(t)) in used
      invariant Apart: forall t, s: T :: has(t) != none and has(t) = has(s) => t = s
      """;

  private static Search.Result checked(String text) throws SourceErrors {
    Sizes sizes = new Sizes(Map.of("T", 2, "V", 2), 2, 1);
    return new Search(new Machine(read(text), sizes), sizes, Map.of(), true, 10_000).run();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          lead != none => the(lead) in live                                       ~ HOLDS
          live != {} => (choose t: T :: t in live) = (choose s: T :: s in copy)   ~ HOLDS
          live != {} and lead != none => the(lead) = (choose t: T :: t in live)   ~ VIOLATED
          (choose n: nat :: n >= top) = top                                       ~ HOLDS
          (choose n: nat :: n >= 1) = 1                                           ~ HOLDS
          (choose n: nat :: n > 2) > 0                                            ~ NOT_DECIDED
          (choose b: bool :: b or top > 5)                                        ~ HOLDS
          top > 0 => (choose n: nat :: n < top) = 0                               ~ HOLDS
          (choose n: nat :: n < top) = 0                                          ~ VIOLATED
          """)
  void checkTakesTheFirstValue(String invariant, Verdict verdict) throws SourceErrors {
    String bounded = LEADER.replaceAll("(?s)action same.*?action look", "action look");
    assertThat(checked(bounded + "invariant I: " + invariant).verdict()).isEqualTo(verdict);
  }

  @Test
  void elementsOfWhichTheFirstIsTakenAreNotAlike() throws SourceErrors {
    assertThat(checked(LEADER).symmetric()).containsExactly("V");
    assertThat(checked(LEADER.replace("some(choose t: T :: t in live)", "none")).symmetric())
        .containsExactlyInAnyOrder("T", "V");
  }

  @Test
  void proofIsOfAnyChoice() throws SourceErrors {
    assertThat(
            proved(
                LEADER.replaceAll("(?s)action same.*?action look", "action look")
                    + """
                    invariant Alive: lead != none => the(lead) in live
                    invariant Equal: live = copy
                    invariant Same:
                      live != {} => (choose t: T :: t in live) = (choose s: T :: s in copy)
                    invariant Low: top <= 2
                    invariant Next: top < 2 => (choose n: nat :: n in top..2 and n != top) = top + 1
                    """))
        .contains(
            "Leader: Alive holds, for any number of T and V",
            "Leader: Same holds, for any number of T and V",
            "Leader: Low holds, for any number of T and V")
        .anyMatch(line -> line.startsWith("Leader: Next does not hold in a start state"));
  }

  @Test
  void oneOfInfinitelyManyIsCheckedAndProved() throws SourceErrors {
    assertThat(checked(FRESH).verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(proved(FRESH))
        .contains(
            "Fresh: Used holds, for any number of T", "Fresh: Apart holds, for any number of T");
    assertThatThrownBy(() ->
            JavaSources.of(
                read(
                    "automaton Fresh[T]\njava \"x.XAutomaton\"\njava T = \"String\"\n"
                        + FRESH.lines().skip(1).reduce("", (a, b) -> a + b + "\n")),
                "x.starl"))
        .hasMessageStartingWith("x.starl:10:22: this set may be infinite");
  }

  @Test
  void choiceDependsOnWhatIsBoundAroundIt() throws SourceErrors {
    String text =
        """
        automaton Pairs[T]
        state
          to: [T -> set[T]]
          one: [T -> option[T]]
        start to = [t: T -> {}], one = [t: T -> none]
        action add(t: T, s: T) eff to(t) := to(t) union {s}
        action settle
          pre forall t: T :: to(t) != {}
          eff one := [t: T -> some(choose s: T :: s in to(t))]
        invariant In: forall t: T :: one(t) != none => the(one(t)) in to(t)
        """;
    assertThat(checked(text).verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(proved(text)).contains("Pairs: In holds, for any number of T");
    assertThat(proved(text.replace("to(t) != {}", "true")))
        .contains("Pairs: settle has no value: nothing satisfies the condition of 'choose'");
  }

  @Test
  void theoryHasTheChoiceOfPvs() throws SourceErrors {
    assertThat(PvsTheory.of(read(LEADER.replace("look", "choose")), "x.starl"))
        .contains(
            "IF enabled(a, s) THEN s WITH [ `lead := up(sets[T].choose({t | s`live(t)})) ]",
            "choose(v): s WITH [ `seen := up(v) ]");
  }

  @Test
  void javaTakesTheLeast() throws SourceErrors {
    Compiled compiled = new Compiled(LEADER);
    compiled.step("join", "b");
    compiled.step("join", "a");
    compiled.step("elect");
    compiled.step("grow");
    assertThat(compiled.state().toString()).contains("lead=up(a)", "top=1");
    assertThat(compiled.enabled("same", 1500L).isTrue()).isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          choose t: T :: t in live            | 25:14: 'choose t: T :: t in live' is of type T; expected bool
          (choose t: T :: live) = t           | 25:30: 'live' is of type set[T]; expected bool
          (choose t: W :: true) = lead        | 25:25: 'W' is no type; expected one of bool, nat, int, time, real, T, V; is it T?
          (choose t in live) = lead           | 25:22: 'choose' is a name here; expected a variable with its type after it: 'choose x: T :: condition'
          (choose top: nat :: top > 1) = 2    | 25:22: 'top' is a component of the state already; expected a new name
          """)
  void mistakeIsTold(String invariant, String told) {
    assertThatThrownBy(() -> read(LEADER + "invariant I: " + invariant))
        .hasMessage("x.starl:" + told);
  }
}
