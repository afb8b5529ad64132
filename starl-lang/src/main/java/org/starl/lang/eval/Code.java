package org.starl.lang.eval;

/** An expression that is ready to be evaluated. */
interface Code {

  /**
   * Its value.
   *
   * @throws EvalError if it has none
   * @throws Beyond if it needs a value beyond the bounds
   */
  Object of(Frame frame);

  default boolean test(Frame frame) {
    return (Boolean) of(frame);
  }

  /** The number of a value, as a place in a row. */
  interface Index {

    int of(Frame frame);
  }

  /** What an evaluation reads. */
  final class Frame {

    /** Calls that nest deeper than this do not end, for all that a small run needs. */
    static final int DEEPEST = 1000;

    final Object[] root;
    final Object[] state;
    final int offset;
    final Object[] locals;
    final int depth;

    /**
     * @param root the values of the run's parameters come first
     * @param state the components, from {@code offset} on
     * @param locals the values of bound variables
     */
    Frame(Object[] root, Object[] state, int offset, Object[] locals, int depth) {
      this.root = root;
      this.state = state;
      this.offset = offset;
      this.locals = locals;
      this.depth = depth;
    }
  }
}
