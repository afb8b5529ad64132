package org.starl.lang.eval;

import org.starl.lang.tree.Pos;

/** An operation has no value, as {@code head([])}. */
public final class EvalError extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final String automaton;
  private final transient Pos pos;

  /**
   * @param automaton in whose source it is
   */
  EvalError(String automaton, Pos pos, String message) {
    super(message, null, false, false);
    this.automaton = automaton;
    this.pos = pos;
  }

  /** The automaton in whose source it is. */
  public String automaton() {
    return automaton;
  }

  /** Where. */
  public Pos pos() {
    return pos;
  }
}
