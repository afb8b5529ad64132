package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.lang.java.Sources.read;

import java.util.List;
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
import org.starl.lang.verdict.Verdict;

/** {@code a..b}, the set of the whole numbers from a to b, in each tool. */
class RangesOfNumbersTest {

  private static final String SHELF =
      """
      automaton Shelf
      java "x.XAutomaton"
      state
        k: nat
        full: [nat -> bool]
        z: int
        s: set[nat]
      start k = 0, forall n: nat :: not full(n), z = -1, s = 1..2
      action put(n: nat)
        pre n in 0..k, k < 2
        eff full(n) := true, k := k + 1, s := 0..k
      action low(c: int)
        pre c in -1..k - 1
        eff z := c
      action all(m: nat)
        pre m <= 2, forall n: nat :: n in 0..m => full(n)
      """;

  private static Verdict checked(String invariant, int nat) throws SourceErrors {
    Sizes sizes = new Sizes(Map.of(), nat, 1);
    Machine machine = new Machine(read(SHELF + "invariant I: " + invariant), sizes);
    return new Search(machine, sizes, Map.of(), true, 10_000).run().verdict();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          k in 0..2                                         ~ HOLDS
          k in 0..1                                         ~ VIOLATED
          not k in 3..5                                     ~ HOLDS
          not k in 1..0                                     ~ HOLDS
          z in -1..k - 1                                    ~ HOLDS
          z in 0..k                                         ~ VIOLATED
          forall n: nat :: n in 0..1 => n <= k + 1          ~ HOLDS
          forall n: nat :: n in 1..k => n + 1 < 3           ~ VIOLATED
          exists n: nat :: n in 0..k and n = k              ~ HOLDS
          card(1..k) = k                                    ~ HOLDS
          card((k..2)) + k = 3                              ~ HOLDS
          card(k + 1..k - 1) = 0                            ~ HOLDS
          card({n: nat | n in 1..k and n != 1}) <= 1      ~ HOLDS
          0..k = {n: nat | n <= k}                        ~ HOLDS
          0..k - 1 subset 0..k                              ~ HOLDS
          (0..0) union (1..1) = 0..1                        ~ HOLDS
          s subset 0..2 and (s = {1, 2} or 0 in s)          ~ HOLDS
          (let r = 0..k :: k in r) and k - 1 in -1..1       ~ HOLDS
          0..3 = {}                                         ~ NOT_DECIDED
          """)
  void rangeIsDecidedByCheck(String invariant, Verdict verdict) throws SourceErrors {
    assertThat(checked(invariant, 2)).isEqualTo(verdict);
  }

  @Test
  void rangeIsProved() throws SourceErrors {
    List<String> lines =
        new Prover(
                read(
                    SHELF.replace(", k < 2", "").replace("m <= 2, ", "")
                        + """
                        invariant Below: forall n: nat :: full(n) => k > 0 and n in 0..k - 1
                        invariant Low: z in -1..k - 1
                        invariant Size: card(1..k) = k and card(0..k) = k + 1
                        invariant Set: k > 0 => s = 0..k - 1
                        """),
                10_000_000,
                (title, text) -> {})
            .prove()
            .lines("x.starl");
    assertThat(lines)
        .contains(
            "Shelf: Below holds", "Shelf: Low holds", "Shelf: Size holds", "Shelf: Set holds");
  }

  @Test
  void rangeIsAComparisonOrASetInTheTheory() throws SourceErrors {
    String theory =
        PvsTheory.of(read(SHELF + "invariant I: card(1..k) <= 2 and s subset 0..2"), "x.starl");
    assertThat(theory)
        .contains("0 <= n AND n <= s`k", "s`s_ = {n | 1 <= n AND n <= 2}")
        .contains(
            "IF 1 <= s`k THEN s`k - 1 + 1 ELSE 0 ENDIF", "subset?(s`s_, {n | 0 <= n AND n <= 2})");
  }

  @Test
  void rangeIsEvaluatedInJava() throws SourceErrors {
    Compiled compiled = new Compiled(SHELF);
    assertThat(compiled.enabled("put", 1L).isTrue()).isFalse();
    assertThat(compiled.enabled("low", -1L).isTrue()).isTrue();
    assertThat(compiled.enabled("low", 0L).isTrue()).isFalse();
    assertThat(compiled.enabled("all", 0L).isTrue()).isFalse();
    compiled.step("put", 0L);
    assertThat(compiled.enabled("all", 0L).isTrue()).isTrue();
    assertThat(compiled.enabled("all", 1L).isTrue()).isFalse();
    compiled.step("put", 1L);
    assertThat(compiled.enabled("all", 1L).isTrue()).isTrue();
    assertThat(compiled.enabled("low", 1L).isTrue()).isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          k in 0..0.5      | 17:22: '0.5' is of type time; expected int
          k in s..2        | 17:19: 's' is of type set[nat]; expected int
          s in 0..2        | 17:14: 's' is of type set[nat]; expected int
          s = -1..2        | 17:18: '-1..2' is of type set[int], and 's' of type set[nat]; expected two of one type
          0..2             | 17:14: '0..2' is of type set[nat]; expected bool
          k in 0..         | 17:22: found the end of the file; expected an expression
          """)
  void mistakeIsTold(String invariant, String told) {
    assertThatThrownBy(() -> read(SHELF + "invariant I: " + invariant))
        .hasMessage("x.starl:" + told);
  }
}
