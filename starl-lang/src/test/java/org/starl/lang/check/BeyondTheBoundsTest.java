package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.lang.check.SearchTest.lines;
import static org.starl.lang.check.SearchTest.result;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.verdict.Verdict;

/** Starts and sets that need numbers beyond the bounds of a search. */
class BeyondTheBoundsTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "c = 0, forall n: nat :: n * n != 289", // so there is none
        "c = 0, not exists n: nat :: n * n = 289",
        "c = 2 or c = 0 and exists n: nat :: n * n = 289",
        "c = card({n: nat | n < 10 and n mod 5 = 0})",
        "c = if exists n: nat :: n * n = 289 then 0 else 1",
        "c = 0, 17 in {n: nat | n * n = 289} => exists n: nat :: n * n = 289",
      })
  void startThatNeedsValuesBeyondTheBoundIsNotDecided(String start) throws SourceErrors {
    String source =
        """
        automaton Begin
        state c: nat
        start %s
        action stay
          eff c := c
        invariant Low: c <= 2
        """
            .formatted(start);
    assertThat(lines(source, 2).getFirst()).contains("not decided").doesNotContain("undefined");
    Search.Result result = result(source.replace("c <= 2", "c > 7"), 2, false);
    assertThat(result.verdict()).isNotEqualTo(Verdict.HOLDS);
    assertThat(lines(source, 2)).noneMatch(line -> line.startsWith("  never false"));
  }

  @Test
  void stateThatIsPerhapsNoStartProvesNothing() throws SourceErrors {
    String source =
        """
        automaton Doubt
        state c: nat
        start c = 0, forall n: nat :: n * n != 289
        action up
          eff c := 1
        invariant Zero: c = 0
        """;
    assertThat(result(source, 2, false).verdict()).isEqualTo(Verdict.NOT_DECIDED);
    assertThat(lines(source, 2))
        .startsWith(
            "Doubt: not decided: Zero is false after 1 step if start holds of the first state",
            "  1. up()   c: 0 -> 1")
        .contains("  not evaluated: start in 1 state, which need values beyond --nat 2, --time 2");
    String sure = source.replace("c = 0, ", "c = 0 or c = 0 and ");
    assertThat(result(sure, 2, false).verdict()).isEqualTo(Verdict.VIOLATED);
  }

  @Test
  void mapsOfAStartStateAreKnownWithinTheBounds() throws SourceErrors {
    String source =
        """
        automaton Begin
        state
          f: [nat -> nat]
          s: set[nat]
        start forall n: nat :: f(n) = 1, s = {n: nat | f(n) = 2}
        action stay
          eff s := s
        invariant One: f(0) = 1 and s = {}
        """;
    assertThat(result(source, 2, false).verdict()).isEqualTo(Verdict.HOLDS);
    String one = source.replace("forall n: nat :: f(n) = 1", "f(0) = 1, f(1) = 1, f(2) = 0");
    assertThat(lines(one.replace("f(1) = 1", "not exists n: nat :: f(n) = 0, f(1) = 1"), 2))
        .contains("  no values to --nat 2, --time 2 meet the assumptions and the start");
    String open = one.replace("f(2) = 0", "f(2) = 0, exists n: nat :: f(n) = 2");
    assertThat(result(open, 2, false).states()).isEqualTo(1); // it is f(3), or another one
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      textBlock =
          """
          forall n: nat :: n in {k: nat | k >= 0} ; HOLDS
          forall n: nat :: n in {k: nat | k >= 1} ; VIOLATED
          not 7 in {n: int | n < 5} ; HOLDS
          -7 in {n: int | n < 5} ; HOLDS
          7 in {n: nat | n mod 7 = 0} ; HOLDS
          forall n: nat :: n in whole ; NOT_DECIDED
          card(whole) > 2 ; NOT_DECIDED
          {n: nat | n > 5} disjoint {n: nat | n < 2} ; NOT_DECIDED
          5 in whole intersect {n: nat | n > 3} ; NOT_DECIDED
          not 5 in {1, 2} ; HOLDS
          1 in {t: time | t < 3} ; HOLDS
          """)
  void setsHaveElementsBeyondTheBound(String invariant, Verdict verdict) throws SourceErrors {
    String source =
        """
        automaton Whole
        fun whole: set[nat] = {n: nat | n >= 0}
        state c: bool
        start c
        action stay
          eff c := c
        invariant A: %s
        """
            .formatted(invariant);
    assertThat(result(source, 2, false).verdict()).isEqualTo(verdict);
  }

  @Test
  void startWithAnInfiniteSetIsNoStateWithinTheBounds() throws SourceErrors {
    String source =
        """
        automaton Whole
        state s: set[nat]
        start s = {n: nat | n > 0}
        action drop(n: nat)
          eff s := s minus {n}
        invariant Many: card(s) > 2
        """;
    assertThat(result(source, 2, false).verdict()).isEqualTo(Verdict.NOT_DECIDED);
    assertThat(lines(source, 2))
        .contains("  not each value is tried, but whole ones to --nat 2, --time 2: s at the start");
  }
}
