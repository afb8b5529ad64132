package org.starl.spec.automaton;

import java.util.List;
import org.starl.spec.Monitor;

/**
 * The claim that each run of a primitive is a run of its theory's automaton, as a monitor. The lemma
 * is the theory's name. A subclass says which event is taken for which action.
 */
public abstract class Conformance implements Monitor {

  private final String theory;
  private final String whose;

  /**
   * @param theory its name: {@code Mutex_decls}
   * @param whose runs they are: {@code every mutex}
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
        ? "The run of " + whose + " is one of the theory's automaton, step by step."
        : "";
  }
}
