package org.starl.lang.read;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Function;

/**
 * How large expressions are with the values of {@code let} and the bodies of functions in their place.
 * Each of 40 lines may double the one before: no tool would end.
 */
final class Expansion {

  static final String TOO_LARGE =
      "for more than 100,000 operations, as each use repeats what it stands for; expected fewer uses";

  private static final long MOST = 100_000;

  private final Map<String, Function> functions = new TreeMap<>();
  private final Map<String, Long> sizes = new TreeMap<>();

  private Expansion(List<Function> functions) {
    functions.forEach(each -> this.functions.put(each.signature().name(), each));
  }

  /** Whether {@code body} with {@code value} in the place of the variable is not too large. */
  static boolean isSmall(Expr body, String variable, Expr value) {
    long uses =
        sum(body, part -> part instanceof Expr.Variable v && v.name().equals(variable) ? 1 : 0);
    return sum(body, part -> 1) + uses * sum(value, part -> 1) <= MOST;
  }

  /**
   * The first that is too large with those that it calls.
   *
   * @param functions do not call each other in a circle
   */
  static Optional<Function> tooLarge(List<Function> functions) {
    Expansion expansion = new Expansion(functions);
    return functions.stream()
        .filter(each -> expansion.size(each.signature().name()) > MOST)
        .findFirst();
  }

  /** Of one function; of those of a used automaton and of Java, 0. */
  private long size(String name) {
    Function function = functions.get(name);
    Long known = sizes.get(name);
    if (function == null || known != null) {
      return known == null ? 0 : known;
    }
    sizes.put(name, 0L); // it may call itself
    long size =
        sum(
            function.body(),
            part ->
                part instanceof Expr.Call call && call.used().isEmpty()
                    ? 1 + size(call.function().name())
                    : 1);
    sizes.put(name, Math.min(size, MOST + 1));
    return Math.min(size, MOST + 1);
  }

  /** Of an expression and all of its parts. */
  private static long sum(Expr at, ToLongFunction<Expr> each) {
    return each.applyAsLong(at) + Exprs.parts(at).stream().mapToLong(part -> sum(part, each)).sum();
  }
}
