package org.starl.spec.automaton;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/** The replays of all instances of a primitive, by source: {@code mutex/crossing}. */
public final class Replays<S, A extends Action> {

  private final Automaton<S, A> automaton;
  private final Steps<S, A> steps;
  private final Map<String, Replay<S, A>> byInstance = new TreeMap<>();

  public Replays(Automaton<S, A> automaton, Steps<S, A> steps) {
    this.automaton = automaton;
    this.steps = steps;
  }

  /** The replay of {@code instance}; created on first use. */
  public Replay<S, A> of(String instance) {
    return byInstance.computeIfAbsent(instance, source -> new Replay<>(automaton, source, steps));
  }

  /** Visits every replay, sorted by instance. */
  public void forEach(Consumer<Replay<S, A>> visitor) {
    byInstance.values().forEach(visitor);
  }
}
