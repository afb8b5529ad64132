package org.starl.lang.eval;

import org.jspecify.annotations.Nullable;

/** A part of a start state that is being looked for. */
final class Hole {

  final Domain domain;

  /** The number of the parameter or component that it is in. */
  final int part;

  /** Null until it is chosen. */
  @Nullable Object value;

  Hole(Domain domain, int part) {
    this.domain = domain;
    this.part = part;
  }

  /** An evaluation needs a part that is not chosen yet. */
  static final class Needed extends RuntimeException {

    private static final long serialVersionUID = 1L;

    final transient Hole hole;

    Needed(Hole hole) {
      super("needed", null, false, false);
      this.hole = hole;
    }
  }
}
