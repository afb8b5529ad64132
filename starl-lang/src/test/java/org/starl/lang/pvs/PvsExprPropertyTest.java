package org.starl.lang.pvs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Collectors;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Binary;

/**
 * PVS gives the operators the same order as the sources do, so a condition in PVS, with its words
 * replaced, is a condition of a source again: it must be the one that was printed.
 */
class PvsExprPropertyTest {

  private static final String BEFORE =
      """
      automaton A
      state n: nat p: bool q: bool
      start true
      action go
      invariant Asked: \
      """;

  @Property(tries = 400)
  void printedConditionIsReadAsTheSame(@ForAll("conditions") String condition) throws SourceErrors {
    Expr expr = read(condition);
    String printed = print(condition);
    assertThat(shown(read(source(printed)))).as(printed).isEqualTo(shown(expr));
  }

  @Property(tries = 400)
  void linesAreShortAndNoneIsLost(@ForAll("conditions") String condition) throws SourceErrors {
    String printed = print(condition);
    assertThat(printed.lines()).allMatch(line -> line.length() <= Doc.WIDTH);
    assertThat(source(printed).replaceAll("[\\s()]", ""))
        .isEqualTo(condition.replaceAll("[\\s()]", ""));
  }

  @Provide
  Arbitrary<String> conditions() {
    return condition(5);
  }

  /** With parentheses around everything. */
  private static Arbitrary<String> condition(int depth) {
    Arbitrary<String> leaf = Arbitraries.of("p", "q", "true");
    if (depth == 0) {
      return leaf;
    }
    Arbitrary<String> smaller = Arbitraries.lazy(() -> condition(depth - 1));
    return Arbitraries.oneOf(
        leaf,
        smaller.map(a -> "(not " + a + ")"),
        pair(smaller, Arbitraries.of("and", "or", "=>", "<=>")),
        pair(number(depth - 1), Arbitraries.of("<", "<=", "=", ">")),
        Combinators.combine(Arbitraries.of("forall", "exists"), smaller)
            .as((word, a) -> "(" + word + " v" + depth + ": nat :: " + a + ")"));
  }

  private static Arbitrary<String> number(int depth) {
    Arbitrary<String> leaf = Arbitraries.of("n", "1", "20");
    if (depth <= 0) {
      return leaf;
    }
    Arbitrary<String> smaller = Arbitraries.lazy(() -> number(depth - 1));
    return Arbitraries.oneOf(leaf, pair(smaller, Arbitraries.of("+", "-", "*")));
  }

  private static Arbitrary<String> pair(Arbitrary<String> side, Arbitrary<String> operator) {
    return Combinators.combine(side, operator, side)
        .as((a, word, b) -> "(" + a + " " + word + " " + b + ")");
  }

  private static Automaton automaton(String condition) throws SourceErrors {
    return new SourceReader().read("a.starl", BEFORE + condition).getFirst();
  }

  private static Expr read(String condition) throws SourceErrors {
    return automaton(condition).invariants().getFirst().condition();
  }

  /** The condition as it stands in the theory. */
  private static String print(String condition) throws SourceErrors {
    String theory = PvsTheory.of(automaton(condition), "x.starl");
    return theory.substring(
        theory.indexOf("Asked(s): bool =") + "Asked(s): bool =".length(),
        theory.lastIndexOf("END A"));
  }

  private static String source(String pvs) {
    return pvs.replace("s`", "")
        .replaceAll("(FORALL|EXISTS) (v\\d):", "$1 $2: nat ::")
        .replace("IMPLIES", "=>")
        .replace("IFF", "<=>")
        .replace("AND", "and")
        .replace("NOT", "not")
        .replace("TRUE", "true")
        .replace("FORALL", "forall")
        .replace("EXISTS", "exists")
        .replace("OR", "or");
  }

  /** With parentheses around everything but the operands of one AND or OR. */
  private static String shown(Expr expr) {
    return switch (expr) {
      case Binary of when isAssociative(of) ->
          operands(of, of.operator()).stream()
              .map(PvsExprPropertyTest::shown)
              .collect(Collectors.joining(" " + of.operator() + " ", "(", ")"));
      case Binary of ->
          "(" + shown(of.left()) + " " + of.operator() + " " + shown(of.right()) + ")";
      case Expr.Not of -> "(NOT " + shown(of.of()) + ")";
      case Expr.Quantified of ->
          "(" + of.forAll() + " " + of.variables() + " " + shown(of.body()) + ")";
      case Expr.Component of -> of.name();
      case Expr.Numeral of -> of.value().toString();
      case Expr.Bool of -> String.valueOf(of.value());
      default -> throw new IllegalStateException(expr.toString());
    };
  }

  private static boolean isAssociative(Binary binary) {
    return binary.operator() == Expr.Operator.AND || binary.operator() == Expr.Operator.OR;
  }

  private static List<Expr> operands(Expr expr, Expr.Operator operator) {
    if (expr instanceof Binary binary && binary.operator() == operator) {
      List<Expr> all = new java.util.ArrayList<>(operands(binary.left(), operator));
      all.addAll(operands(binary.right(), operator));
      return all;
    }
    return List.of(expr);
  }
}
