package org.starl.spec.automaton;

import java.util.List;
import org.starl.spec.Monitor;

/**
 * A monitor that checks that each run of a primitive is a run of its theory's automaton. The lemma
 * has the theory's name. A subclass maps trace events to actions.
 */
public abstract class Conformance implements Monitor {

  private final String theory;
  private final String whose;

  /**
   * @param theory the theory's name, such as {@code Mutex_decls}
   * @param whose the checked runs, such as {@code every mutex}
   */
  protected Conformance(String theory, String whose) {
    this.theory = theory;
    this.whose = whose;
  }

  @Override
  public final List<String> lemmas() {
    return List.of(theory);
  }

  @Override
  public final String says(String lemma) {
    return lemma.equals(theory)
        ? "Each run of " + whose + " is a run of the theory's automaton, step by step."
        : "";
  }
}
