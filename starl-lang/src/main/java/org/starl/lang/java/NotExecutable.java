package org.starl.lang.java;

import org.starl.lang.tree.Pos;

/** A part of an automaton has no executable form. */
final class NotExecutable extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final transient Pos pos;

  NotExecutable(Pos pos, String message) {
    super(message);
    this.pos = pos;
  }

  Pos pos() {
    return pos;
  }
}
