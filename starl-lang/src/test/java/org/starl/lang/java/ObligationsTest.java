package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.check.Search;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.prove.Prover;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.verdict.Verdict;
import org.starl.spec.automaton.Undefined;

/** The table of docs/language.md: each tool asks that operations have values, and that effects are some. */
class ObligationsTest {

  private static final long LIMIT = 10_000_000;

  private static final String SOURCE =
      """
      automaton Partial[T]
      java "x.XAutomaton"
      java time = "double"
      type Form = none_yet | one(at: nat)
      state
        n: nat
        w: time
        o: option[nat]
        l: list[T]
        f: Form
        m: [T -> nat]  r: 0..3
      start n = 0, r = 3, w = 0, o = none, l = [], f = none_yet, forall t: T :: m(t) = 0
      action go(t: T, u: T) eff EFFECT
      action fill eff o := some(1)
      """;

  private static final String LAMP =
      """
      automaton Lamp
      state isOn: bool
      start isOn = false
      action on pre not isOn eff isOn := true
      automaton Room
      java "x.XAutomaton"
      uses lamp: Lamp
      start lamp.start?
      action twice eff lamp.on()
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          n := the(o) | 13:32: the(none) has no value | `n := down(s`o_)
          m(t) := if head(l) = t then 1 else 2 | 13:38: head([]) has no value | IF car(s`l) = t
          l := tail(l) | 13:32: tail([]) has no value | `l := cdr(s`l)
          m(t) := if l(n) = t then 1 else 2 | 13:38: the list has 0 elements, and none at 0 | IF nth(s`l, s`n) = t
          n := f.at | 13:32: 'at' of none_yet, which has no such field | `n := at(s`f)
          n := n - 1 | 13:32: 0 - 1 is below 0 | `n := s`n - 1
          n := choose k: nat :: k in 1..n | 13:32: nothing satisfies the condition of 'choose' | `n := sets[nat].choose({k | 1 <= k AND k <= s`n})
          r := r + 1 | 13:32: 4 is not in 0..3 | `r := s`r + 1
          w := w - 1 | 13:32: 0.0 - 1.0 is below 0 | `w := s`w - 1
          w := 1 / w | 13:32: a division by 0 | `w := 1 / s`w
          n := 1 mod n | 13:32: a remainder by 0; expected a number above 0 | `n := modulo_arithmetic.rem(s`n)(1)
          """)
  void eachToolAsksThatOperationsHaveValues(String effect, String told, String typed)
      throws SourceErrors {
    String text = SOURCE.replace("EFFECT", effect);
    assertAsked(text, told);
    // The type of the result is PVS's condition, where the action is enabled.
    assertThat(PvsTheory.of(last(text), "x.starl"))
        .containsSubsequence("IF enabled(a, s) THEN", typed, "ELSE s ENDIF");
  }

  @Test
  void allButPvsAskThatOnePlaceIsNotChangedTwice() throws SourceErrors {
    String text = SOURCE.replace("EFFECT", "m(t) := 1, m(u) := 2");
    assertAsked(text, "13:38: 'go' changes one place twice; expected one effect on it");
    assertThat(PvsTheory.of(last(text), "x.starl"))
        .contains("go(t, u): s WITH [ `m(t) := 1, `m(u) := 2 ]");
  }

  @Test
  void cardOfASetThatIsNotKnownToBeFiniteIsNotDecided() throws SourceErrors {
    String text = SOURCE.replace("EFFECT", "n := card({k: nat | k > n})");
    assertThat(checked(last(text)).verdict()).isEqualTo(Verdict.NOT_DECIDED);
    assertThat(new Prover(last(text), LIMIT, (name, script) -> {}).prove().lines("x.starl"))
        .contains(
            "Partial: go perhaps has no value: card of an infinite set: not decided",
            "  at x.starl:13:32");
    assertThat(PvsTheory.of(last(text), "x.starl"))
        .containsSubsequence("IF enabled(a, s) THEN", "`n := card({k | k > s`n})", "ELSE s ENDIF");
    assertThatThrownBy(() -> JavaSources.of(last(text), "x.starl"))
        .isInstanceOf(SourceErrors.class)
        .hasMessageStartingWith("x.starl:13:47: the values of 'k' that matter here");
  }

  @Test
  void allButPvsAskThatStepsOfUsedAutomataAreEnabled() throws SourceErrors {
    assertAskedAt("9:18", LAMP);
    assertThat(PvsTheory.of(last(LAMP), "x.starl"))
        .contains("twice: s WITH [ `lamp := Lamp.trans(on, s`lamp) ]");
    Compiled compiled = new Compiled(LAMP);
    assertThat(compiled.step("twice")).isEqualTo("States[lamp=States[isOn=true]]");
    assertThatThrownBy(() -> compiled.after("twice"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:9:18: lamp.on is not enabled: not isOn is false: isOn = true");
  }

  private static void assertAsked(String text, String told) throws SourceErrors {
    assertAskedAt(told.substring(0, told.indexOf(": ")), text);
    Compiled compiled = new Compiled(text);
    assertThatThrownBy(() -> compiled.after("go", "t", "t"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:" + told);
  }

  /** By {@code check} and {@code prove}. */
  private static void assertAskedAt(String place, String text) throws SourceErrors {
    assertThat(checked(last(text)).finding())
        .hasValueSatisfying(finding -> assertThat(finding.pos()).hasToString(place));
    assertThat(new Prover(last(text), LIMIT, (name, script) -> {}).prove().lines("x.starl"))
        .contains("  at x.starl:" + place);
  }

  private static Automaton last(String text) throws SourceErrors {
    return new SourceReader().read("x.starl", text).getLast();
  }

  private static Search.Result checked(Automaton automaton) {
    Sizes sizes = new Sizes(automaton.typeParameters().isEmpty() ? Map.of() : Map.of("T", 2), 2, 2);
    return new Search(new Machine(automaton, sizes), sizes, Map.of(), true, 1000).run();
  }
}
