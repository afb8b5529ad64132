package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.read.SourceErrors;
import org.starl.spec.automaton.Fun;

/** Maps that give each argument a value of its own, at the start or as a parameter. */
class OwnValuesTest {

  private static final String HEAD =
      """
      automaton Own[P, f: [P -> nat], h: [P -> [P -> bool]]]
      java "x.XAutomaton"
      java P = "String"
      state
        next: [0..2 -> 0..2]
        back: [bool -> bool]
        boss: [P -> P]
        chief: [P -> P]
        n: [P -> nat]
        all: [P -> bool]
        list: list[nat]
      start (forall i: 0..2 :: next(i) = i), (forall b: bool :: back(b) = not b),
        (forall p: P :: boss(p) = p), (forall p: P :: chief(p) = p), n = [p: P -> 0],
        all = [p: P -> true], list = [3, 1]
      fun first(m: [P -> nat], p: P): nat = m(p)
      """;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "next = [i: 0..2 -> i]",
        "back = [b: bool -> not b]",
        "next(1) = 1 and back(false)",
        "forall i: 0..1 :: i < length(list) => list(i) >= 1",
        "exists i: 0..1, j: 0..1 :: list(i) = list(j) + 2"
      })
  void conditionHoldsAtTheStart(String condition) throws SourceErrors {
    Compiled own = new Compiled(HEAD.replaceFirst(", f: .*", "]") + "action a\n  pre " + condition);
    assertThat(own.enabled("a").isTrue()).isTrue();
  }

  private static final String COPIES =
      """
      automaton Copies[P]
      java "x.XAutomaton"
      java P = "String"
      type R = record(a: nat, b: nat)
      state
        z: nat
        y: nat
        x: nat
        free: nat
        same: nat
        r: R
        m: [P -> nat]
        k: [P -> nat]
      fun more: nat = x + 1
      start z = y + 1, y = x, x = 2, r.a = z, r.b = 7, (forall p: P :: m(p) = r.b), k = m,
        same = free
      """;

  @Test
  void startValuesMayBeThoseOfOtherComponents() throws SourceErrors {
    Compiled copies =
        new Compiled(
            COPIES
                + "action a(p: P) pre z = 3 and y = 2 and r = R(a := 3, b := 7) and m(p) = 7 and"
                + " k(p) = 7 and same = free");
    assertThat(copies.enabled("a", "bot0").isTrue()).isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          x = y          ~ 15:25: this start value depends on itself
          x = x          ~ 15:25: this start value depends on itself
          x = more       ~ 15:29: this start value depends on itself, or on a function of the state
          """)
  void startValueThatDependsOnItselfIsRefused(String equation, String told) {
    assertThatThrownBy(() -> Compiled.files(COPIES.replace("x = 2", equation) + "action a"))
        .hasMessageContaining(told);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          pre boss = chief          ~ 17:5: each argument has a value of its own at the start
          pre chief != boss         ~ 17:5: each argument has a value of its own at the start
          pre n = f                 ~ 17:9: 'f' is a method in Java; expected arguments after it
          pre first(f, p) = 0       ~ 17:11: 'f' is a method in Java; expected arguments after it
          eff n := f                ~ 17:10: 'f' is a method in Java; expected arguments after it
          """)
  void whatJavaDoesNotCompareIsRefused(String part, String told) {
    assertThatThrownBy(() -> Compiled.files(HEAD + "action a(p: P)\n" + part))
        .hasMessageContaining(told);
  }

  @Test
  void argumentsOfAParameterHaveItsValues() throws SourceErrors {
    Function<String, Long> f = p -> 7L;
    Function<String, Fun<String, Boolean>> h = p -> Fun.always(false);
    Compiled own =
        new Compiled(
            Compiled.files(HEAD + "action a(p: P) pre f(p) = 7 and not h(p)(p) eff all := h(p)"),
            new Object[] {f, h});
    assertThat(own.enabled("a", "bot0").isTrue()).isTrue();
  }

  @Test
  void namesOfTheClassAreNamesOfTheSource() throws SourceErrors {
    Compiled own =
        new Compiled(
            """
            automaton X[theory: nat, start: nat, X: nat]
            java "x.XAutomaton"
            type Math = some_math | other
            state
              math: Math
              n: nat
            start math = some_math, n = 5
            action a
              pre n mod 3 = theory, n = start, n mod 2 = X, math = some_math
            """,
            2,
            5,
            1);
    assertThat(own.enabled("a").isTrue()).isTrue();
    own =
        new Compiled(
            "automaton Y\njava \"x.XAutomaton\"\ntype Y = aa | bb\nstate y: Y start y = bb action a pre y = bb");
    assertThat(own.enabled("a").isTrue()).isTrue();
  }
}
