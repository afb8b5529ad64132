package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.lang.java.Sources.proved;
import static org.starl.lang.java.Sources.read;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.check.Search;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.verdict.Verdict;
import org.starl.spec.automaton.Undefined;

/** {@code 0..N - 1} as a type, where {@code N} is a parameter, in each tool. */
class RangesOfParametersTest {

  /** A token goes round in a ring; each place has a flag. */
  private static final String RING =
      """
      automaton Ring[N: nat, first: 0..N-1]
      java "x.XAutomaton"
      assume Some: N > 0
      type Slot = 0..(N - 1)
      state
        token: Slot
        has: [Slot -> bool]
        free: set[0..-1+N]
        off: -N..2*N
      start token = first, forall s: Slot :: has(s), free = {}, off = 0
      action pass
        eff token := (token + 1) mod N
      action back
        eff token := (token - 1) mod N
      action take(s: Slot)
        pre has(s), s = token
        eff has(s) := false, free := free union {s}
      action refill
        pre free = 0..N-1
        eff free := {}, has := [s: Slot -> true]
      """;

  /** Dijkstra, Self-stabilizing systems in spite of distributed control, 1974. */
  private static final String DIJKSTRA =
      """
      automaton Dijkstra[N: nat, K: nat]
      assume Sizes: N > 1 and K > 0
      state x: [0..N-1 -> 0..K-1]
      fun privileged(i: 0..N-1): bool = if i = 0 then x(0) = x(N - 1) else x(i) != x(i - 1)
      start true
      action bottom fair pre privileged(0) eff x(0) := (x(0) + 1) mod K
      action other(i: 1..N-1) fair pre privileged(i) eff x(i) := x(i - 1)
      invariant Some: exists i: 0..N-1 :: privileged(i)
      progress Stable: eventually card({i: 0..N-1 | privileged(i)}) = 1
      """;

  /** As in Lamport's Specifying Systems: a buffer of N places. */
  private static final String BUFFER =
      """
      automaton Buffer[V, N: nat]
      java "x.XAutomaton"
      assume Some: N > 0
      state
        buf: [0..N-1 -> option[V]]
        p: 0..N-1
        c: 0..N-1
        n: 0..N
      start (forall i: 0..N-1 :: buf(i) = none), p = 0, c = 0, n = 0
      action put(v: V) pre n < N eff buf(p) := some(v), p := (p + 1) mod N, n := n + 1
      action get pre n > 0 eff buf(c) := none, c := (c + 1) mod N, n := n - 1
      """;

  private static Search.Result checked(String text, Map<String, Integer> numbers)
      throws SourceErrors {
    Sizes sizes = new Sizes(Map.of("V", 2), 1, 1, numbers);
    return new Search(new Machine(read(text), sizes), sizes, Map.of(), false, 100_000).run();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          token <= N - 1 and off >= -N                      ~ HOLDS
          token < N - 1                                     ~ VIOLATED
          forall s: Slot :: s in free <=> not has(s)        ~ HOLDS
          exists s: Slot :: has(s)                          ~ VIOLATED
          exists s: 0..N-1 :: s > N - 2                     ~ HOLDS
          exists s: 0..N :: s = N                           ~ HOLDS
          card({s: Slot | has(s)}) + card(free) = N         ~ HOLDS
          has = [s: 0..N-1 -> not s in free]                ~ HOLDS
          (choose s: Slot :: s >= token) = token            ~ HOLDS
          0 <= (off - 1) mod N and (token + N) mod N = token ~ HOLDS
          """)
  void allValuesAreVisitedWhateverTheBounds(String invariant, Verdict verdict) throws SourceErrors {
    String text = RING + "invariant I: " + invariant;
    assertThat(checked(text, Map.of("N", 5)).verdict()).isEqualTo(verdict);
  }

  @Test
  void statesAreAsManyAsCountedByHand() throws SourceErrors {
    for (int n = 1; n <= 4; n++) {
      // Each place of the token, each set of free places.
      assertThat(checked(RING, Map.of("N", n)).states()).isEqualTo(n * n << n);
      // Each place to read, each list of up to n of 2 values.
      assertThat(checked(BUFFER, Map.of("N", n)).states()).isEqualTo(n * ((2 << n) - 1));
    }
  }

  /** It stabilises with N - 1 values or more: Dolev's book has the proof. */
  @Test
  void ringOfDijkstraStabilisesWithEnoughValues() throws SourceErrors {
    Search.Result enough = checked(DIJKSTRA, Map.of("N", 4, "K", 3));
    assertThat(enough.verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(enough.states()).isEqualTo(81);
    assertThat(checked(DIJKSTRA, Map.of("N", 4, "K", 2)).finding())
        .hasValueSatisfying(finding -> assertThat(finding.name()).isEqualTo("Stable"));
  }

  @Test
  void eachNumberThatIsAssumedIsASize() throws SourceErrors {
    Sizes sizes = new Sizes(Map.of(), 3, 1);
    assertThat(Machine.sizes(read(DIJKSTRA), sizes, Map.of("K", 7)))
        .extracting(Sizes::numbers)
        .containsExactly(Map.of("K", 7, "N", 2), Map.of("K", 7, "N", 3));
    assertThat(Machine.sizes(read(DIJKSTRA), sizes, Map.of("K", 7, "N", 1))).hasSize(1);
    assertThat(Machine.sizes(read(DIJKSTRA), new Sizes(Map.of(), 1, 1), Map.of())).isEmpty();
  }

  @Test
  void invariantsAreProvedForAnyNumber() throws SourceErrors {
    assertThat(
            proved(
                RING
                    + """
                    invariant In: token <= N - 1 and off >= -N
                    invariant Free: forall s: Slot :: s in free <=> not has(s)
                    invariant Size: card({s: Slot | has(s)}) + card(free) = N
                    """))
        .contains(
            "Ring: In holds, for any N",
            "Ring: Free holds, for any N",
            "Ring: Size holds for N to 5; for more it is not decided")
        .noneMatch(line -> line.contains("range") || line.contains("not in"));
    assertThat(proved(BUFFER + "invariant Count: n <= N invariant Place: p = (c + n) mod N"))
        .contains("Buffer: Count holds, for any number of V and any N");
  }

  @Test
  void numberOutsideIsTold() throws SourceErrors {
    String text = RING.replace("(token + 1) mod N", "token + 1");
    assertThat(checked(text, Map.of("N", 3)).finding())
        .hasValueSatisfying(finding -> {
          assertThat(finding.message()).isEqualTo("3 is not in 0..2");
          assertThat(finding.pos()).hasToString("12:16");
        });
    assertThat(proved(text))
        .containsSubsequence(
            "Ring: pass makes a number that is not in 0..N - 1",
            "  at x.starl:12:16",
            "  with    N = 1");
    Compiled compiled = new Compiled(text, 3, 1);
    compiled.step("pass");
    assertThatThrownBy(() -> compiled.after("pass"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:12:16: 3 is not in 0..2");
    assertThat(PvsTheory.of(read(text), "x.starl"))
        .contains("Slot: TYPE = subrange(0, N - 1)", "s WITH [ `token := s`token + 1 ]");
  }

  @Test
  void rangeThatMayBeEmptyIsTold() throws SourceErrors {
    String text = BUFFER.replace("assume Some: N > 0\n", "");
    assertThatThrownBy(() -> checked(text, Map.of("N", 0)))
        .isInstanceOfSatisfying(
            EvalError.class,
            e -> {
              assertThat(e).hasMessage("the range 0..-1 is empty");
              assertThat(e.pos()).hasToString("4:9");
            });
    assertThat(proved(text))
        .containsSubsequence(
            "Buffer: start has an empty range, 0..N - 1", "  at x.starl:4:9", "  with    N = 0");
    assertThat(proved(BUFFER)).noneMatch(line -> line.contains("range"));
    assertThatThrownBy(() -> new Compiled(text, 0))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:4:9: the range 0..-1 is empty");
    assertThat(new Compiled(text, 1).state()).contains("p=0, c=0, n=0");
    assertThat(PvsTheory.of(read(text), "x.starl"))
        .contains("  ASSUMING\n    nonempty?1: ASSUMPTION 0 <= N - 1\n  ENDASSUMING\n");
  }

  @Test
  void rangeIsALongInJava() throws SourceErrors {
    Compiled compiled = new Compiled(RING, 3, 2);
    assertThat(compiled.state()).contains("token=2");
    assertThat(compiled.step("pass")).contains("token=0");
    assertThat(compiled.enabled("refill").isTrue()).isFalse();
    for (long s : List.of(0L, 2L, 1L)) {
      compiled.step("take", s);
      compiled.step("back");
    }
    assertThat(compiled.enabled("take", 0L).isTrue()).isFalse();
    assertThat(compiled.enabled("refill").isTrue()).isTrue();
    compiled.step("refill");
    assertThat(compiled.enabled("take", 0L).isTrue()).isTrue();
  }

  @Test
  void boundsAreWrittenAsPvsReadsThem() throws SourceErrors {
    assertThat(PvsTheory.of(read(RING), "x.starl"))
        .contains(
            "Ring [ N: nat, first: subrange(0, N - 1) ]: THEORY",
            "off: subrange(0 - N, 2 * N)",
            "`token := modulo_arithmetic.rem(N)(s`token + 1)");
  }

  @Test
  void rangeInsideAnotherIsPartOfIt() throws SourceErrors {
    String text =
        RING
            + """
            fun part(i: 0..N-1): 0..N = i
            fun next(i: 0..N-1): 1..N = i + 1
            """;
    String theory = String.join("", Compiled.files(text).values());
    assertThat(theory).contains("return i;", "within(\"x.starl:22:29\", 1L, N, i + 1)");
  }

  @Test
  void parameterStandsBeforeTheRangesThatNeedIt() {
    assertThatThrownBy(() -> read(RING.replace("N: nat, first: 0..N-1", "first: 0..N-1, N: nat")))
        .hasMessageStartingWith("x.starl:1:26: 'N-1' is no bound of a type");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "assume A: W > 0 and K > W",
        "assume A: W > 0 assume B: W < K",
        "assume A: forall p: P :: f(p) < K and W > f(p) and K > W",
      })
  void assumptionsOnSeveralParametersLeaveNoRangeEmpty(String assumptions) throws SourceErrors {
    String text =
        """
        automaton Several[P, K: nat, W: nat, f: [P -> nat]]
        %s
        state x: 0..K - 1
        start x = 0
        action last eff x := K - 1
        invariant Ends: x = 0 or x = K - 1
        """
            .formatted(assumptions);
    assertThat(proved(text)).contains("Several: Ends holds, for any number of P and any K");
    assertThat(Machine.sizes(read(text), new Sizes(Map.of("P", 2), 2, 1), Map.of()))
        .extracting(each -> each.numbers().get("K"))
        .containsExactly(2);
  }

  @ParameterizedTest
  @ValueSource(strings = {"N > 0 and first < N", "first < N and N > 0"})
  void assumptionThatIsAlsoOfAValueInARangeLeavesNoRangeEmpty(String assumption)
      throws SourceErrors {
    String text =
        """
        automaton Both[N: nat, first: 0..N]
        assume A: %s
        state at: 0..N - 1
        start at = first
        action stay
          eff at := at
        invariant Low: at < N
        """
            .formatted(assumption);
    assertThat(proved(text)).contains("Both: Low holds, for any N");
    assertThat(Machine.sizes(read(text), new Sizes(Map.of(), 2, 1), Map.of()))
        .extracting(each -> each.numbers().get("N"))
        .containsExactly(1, 2);
  }
}
