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
import org.starl.spec.automaton.Undefined;

/** {@code 0..3} as a type, in each tool. */
class RangeTypesTest {

  /** A token goes round in a ring of four; each place has a flag. */
  private static final String RING =
      """
      automaton Ring
      java "x.XAutomaton"
      type Slot = 0..3
      state
        token: Slot
        has: [Slot -> bool]
        free: set[Slot]
        off: -2..2
        last: option[Slot]
      start token = 0, forall s: Slot :: has(s), free = {}, off = -1, last = none
      action pass
        eff token := if token = 3 then 0 else token + 1, last := some(token)
      action take(s: Slot)
        pre has(s), s = token
        eff has(s) := false, free := free union {s}
      action tune(d: -1..1)
        pre off + d >= -2, off + d <= 2
        eff off := off + d
      """;

  /** As in Lamport's Specifying Systems: a buffer of three places. */
  private static final String BUFFER =
      """
      automaton Buffer[V]
      state
        buf: [0..2 -> option[V]]
        p: 0..2
        c: 0..2
        n: 0..3
      start (forall i: 0..2 :: buf(i) = none), p = 0, c = 0, n = 0
      fun next(i: 0..2): 0..2 = if i = 2 then 0 else i + 1
      action put(v: V) pre n < 3 eff buf(p) := some(v), p := next(p), n := n + 1
      action get pre n > 0 eff buf(c) := none, c := next(c), n := n - 1
      """;

  private static Search.Result checked(String text) throws SourceErrors {
    Sizes sizes = new Sizes(Map.of("V", 2), 1, 1);
    return new Search(new Machine(read(text), sizes), sizes, Map.of(), true, 10_000).run();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          token <= 3 and off >= -2 and off <= 2                       ~ HOLDS
          token < 3                                                   ~ VIOLATED
          forall s: Slot :: s in free <=> not has(s)                  ~ HOLDS
          exists s: Slot :: has(s)                                    ~ VIOLATED
          exists s: Slot :: s > 2                                     ~ HOLDS
          exists s: 0..2 :: s > 2                                     ~ VIOLATED
          card({s: Slot | has(s)}) + card(free) = 4                   ~ HOLDS
          has = [s: 0..3 -> not s in free]                            ~ HOLDS
          last = none or the(last) != token                           ~ HOLDS
          (choose s: Slot :: s >= token) = token                      ~ HOLDS
          token - off >= -2 and off - token <= 2 and token * 2 <= 6   ~ HOLDS
          token + off < 5                                             ~ VIOLATED
          """)
  void allValuesAreVisitedWhateverTheBounds(String invariant, Verdict verdict) throws SourceErrors {
    assertThat(checked(RING + "invariant I: " + invariant).verdict()).isEqualTo(verdict);
  }

  @Test
  void startOutsideIsNone() throws SourceErrors {
    Search.Result result = checked(RING.replace("token = 0, forall", "token = off + 5, forall"));
    assertThat(result.states()).isZero();
    assertThat(result.bounded()).isEmpty();
  }

  @Test
  void invariantsOfRangesAreProved() throws SourceErrors {
    assertThat(
            proved(
                RING
                    + """
                    invariant In: token <= 3 and off >= -2
                    invariant Free: forall s: Slot :: s in free <=> not has(s)
                    invariant Size: card({s: Slot | has(s)}) + card(free) = 4
                    """))
        .contains("Ring: In holds", "Ring: Free holds", "Ring: Size holds")
        .noneMatch(line -> line.contains("not in") || line.contains("not decided"));
    assertThat(
            proved(
                BUFFER
                    + """
                    invariant Count: n = card({i: 0..2 | buf(i) != none})
                    invariant Dist: p + 3 = c + n or p = c + n or p + 6 = c + n + 3
                    invariant Full:
                      forall i: 0..2 ::
                        buf(i) != none <=> n > 0 and ((c <= i and i < c + n) or i + 3 < c + n)
                    """))
        .contains(
            "Buffer: Count holds, for any number of V",
            "Buffer: Dist holds, for any number of V",
            "Buffer: Full holds, for any number of V");
  }

  @Test
  void numberOutsideIsTold() throws SourceErrors {
    String text = RING.replace("if token = 3 then 0 else token + 1", "token + 1");
    assertThat(checked(text).finding())
        .hasValueSatisfying(finding -> {
          assertThat(finding.message()).isEqualTo("4 is not in 0..3");
          assertThat(finding.pos()).hasToString("12:16");
        });
    assertThat(proved(text))
        .contains("Ring: pass makes a number that is not in 0..3", "  at x.starl:12:16");
    Compiled compiled = new Compiled(text);
    for (int i = 0; i < 3; i++) {
      compiled.step("pass");
    }
    assertThatThrownBy(() -> compiled.after("pass"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:12:16: 4 is not in 0..3");
  }

  @Test
  void rangeIsASubtypeInTheTheory() throws SourceErrors {
    assertThat(PvsTheory.of(read(RING.replace("pass", "subrange")), "x.starl"))
        .contains(
            "Slot: TYPE = subrange(0, 3)",
            "off: subrange(0 - 2, 2)",
            "tune(d: subrange(0 - 1, 1)): tune?",
            "subrange_: subrange_?");
  }

  @Test
  void rangeIsALongInJava() throws SourceErrors {
    Compiled compiled =
        new Compiled(
            RING.replace("has(s), free = {}", "not has(s), free = {}")
                + """
                action all pre forall s: Slot :: has(s) = (s in free)
                action fill eff has := [s: Slot -> true]
                action same pre has = [s: Slot -> true], exists s: Slot :: s = token and s < 1
                """);
    assertThat(compiled.enabled("all").isTrue()).isTrue();
    assertThat(compiled.enabled("same").isTrue()).isFalse();
    compiled.step("fill");
    assertThat(compiled.enabled("all").isTrue()).isFalse();
    assertThat(compiled.enabled("same").isTrue()).isTrue();
    compiled.step("pass");
    assertThat(compiled.enabled("same").isTrue()).isFalse();
    assertThat(
            new Compiled(RING + "action same pre has = [s: Slot -> true]").enabled("same").isTrue())
        .isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          state x: 3..1            | 2:10: the range 3..1 is empty; expected the lower number first
          state x: 0..1.5          | 2:13: '1.5' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of the automaton, and sums of them; others in a condition: 'i in 0..n'
          state x: 0..K - 1        | 2:13: 'K - 1' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of the automaton, and sums of them; others in a condition: 'i in 0..n'
          state x: 0..T            | 2:13: 'T' is a type; expected 'T: nat' as a parameter
          state x: 0..1 start forall i in 0..1 :: x >= i | 2:30: found 'in'; expected ':' and a type after a variable, as in 'forall i: 0..3 :: ...'
          state x: 0..Z            | 2:13: 'Z' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of the automaton, and sums of them; others in a condition: 'i in 0..n'
          state x: 0..N * (N - 1)  | 2:13: 'N * (N - 1)' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of the automaton, and sums of them; others in a condition: 'i in 0..n'
          state x: 0..99*999999999*999999999*N | 2:13: '99*999999999*999999999*N' is no bound of a type; expected whole numbers of at most 9 digits, nat parameters of the automaton, and sums of them; others in a condition: 'i in 0..n'
          state x: N..N - 1        | 2:10: the range N..N - 1 is empty; expected the lower number first
          state x: 0..N - 1 start x | 2:25: 'x' is of type 0..N - 1; expected bool
          state x: set[0..N] y: set[0..3] action a eff x := y | 2:51: 'y' is of type set[0..3]; expected set[0..N]
          state x: set[0..N - 1] action a eff x := 0..N | 2:42: '0..N' is of type set[nat]; expected set[0..N - 1]
          state x: 0..2 start x    | 2:21: 'x' is of type 0..2; expected bool
          state x: 0..2 action a eff x := 3    | 2:33: '3' is not in 0..2; expected one of these numbers
          state x: 0..2 action a eff x := -1   | 2:33: '-1' is not in 0..2; expected one of these numbers
          state x: 0..2 action a eff x := 0.5  | 2:33: '0.5' is of type time; expected 0..2
          state x: set[0..2] action a eff x := {1, 3} | 2:42: '3' is not in 0..2; expected one of these numbers
          state x: set[0..2] y: set[nat] action a eff x := y | 2:50: 'y' is of type set[nat]; expected set[0..2]
          """)
  void mistakeIsTold(String parts, String told) {
    assertThatThrownBy(() -> read("automaton A[N: nat, Z: int, T]\n" + parts))
        .hasMessage("x.starl:" + told);
  }
}
