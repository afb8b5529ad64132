package org.starl.primitives.conformance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.BiFunction;
import java.util.function.Predicate;
import net.jqwik.api.statistics.Statistics;
import org.starl.random.Rng;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Automaton;

/** A run of an automaton in which what comes next is drawn, for properties. */
public final class RandomRun<S, A extends Action> {

  private static final int STEPS = 400;

  /** Looks at a step. */
  public interface Proved<S, A> {

    /** What does not hold though it is proved; empty if all does. */
    String broken(S before, A action, S after);
  }

  private final Automaton<S, A> automaton;
  private final BiFunction<Rng, S, A> any;
  private final Proved<S, A> proved;

  /**
   * @param any draws an action, enabled or not
   */
  public RandomRun(Automaton<S, A> automaton, BiFunction<Rng, S, A> any, Proved<S, A> proved) {
    this.automaton = automaton;
    this.any = any;
    this.proved = proved;
  }

  /**
   * Goes through one, and fails at the first step that breaks what is proved. Fails as well if in half
   * of the property's runs, or more, next to nothing happens.
   *
   * @param telling actions that tell that much happened
   * @param least how many of them are enough
   */
  public void check(long seed, Predicate<A> telling, int least) {
    Rng rng = new Rng(seed);
    S s = automaton.start();
    int told = 0;
    for (int step = 0; step < STEPS; step++) {
      A action = any.apply(rng, s);
      if (automaton.enabled(action, s).isTrue()) {
        S before = s;
        s = automaton.trans(action, s);
        told += telling.test(action) ? 1 : 0;
        assertThat(proved.broken(before, action, s))
            .as("seed %d, after %s: %s", seed, action.text(), s)
            .isEmpty();
      }
    }
    // That much happens in most runs is what makes the property worth its name.
    Statistics.collect(told >= least);
    Statistics.coverage(runs -> runs.check(true).percentage(share -> share > 50));
  }
}
