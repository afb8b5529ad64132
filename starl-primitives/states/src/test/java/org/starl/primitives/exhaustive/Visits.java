package org.starl.primitives.exhaustive;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToIntFunction;
import org.starl.primitives.exhaustive.StateSearch.Outcome;

/** Visits all states of a protocol, for tests. */
public final class Visits {

  private static final int MOST_STATES = 1_000_000;

  private Visits() {}

  /** The bounds of {@code space}: {@code robots=3 crashes=1}, the others as usual. */
  public static ToIntFunction<String> bounds(StateSpace space, String given) {
    Map<String, Integer> bounds = new TreeMap<>();
    space.bounds().forEach(bound -> bounds.put(bound.name(), bound.usual()));
    for (String each : given.split(" ")) {
      String[] parts = each.split("=");
      assertThat(bounds.put(parts[0], Integer.valueOf(parts[1]))).as(each).isNotNull();
    }
    return bounds::get;
  }

  /** These bounds give so many states, in which all invariants hold; in some the goal is reached. */
  public static void assertHolds(StateSpace space, String given, int states) {
    Outcome outcome = run(space.search().apply(bounds(space, given)));
    assertThat(outcome.violation()).isEmpty();
    assertThat(outcome.isComplete()).isTrue();
    assertThat(outcome.reached()).isPositive();
    assertThat(outcome.states()).isEqualTo(states);
  }

  /** The search finds a violation of this invariant. */
  public static void assertFinds(StateSearch<?, ?, ?> search, String invariant) {
    assertThat(run(search).violation()).last().asString().startsWith(invariant + ": ");
  }

  private static Outcome run(StateSearch<?, ?, ?> search) {
    return search.run(MOST_STATES, states -> {});
  }
}
