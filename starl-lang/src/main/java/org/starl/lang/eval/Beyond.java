package org.starl.lang.eval;

/** A number or a list is beyond the bounds of the run. */
public final class Beyond extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Whether it is an argument of a map that is known within the bounds alone. */
  private final boolean isArgument;

  Beyond() {
    this(false);
  }

  private Beyond(boolean isArgument) {
    super("beyond the bounds", null, false, false);
    this.isArgument = isArgument;
  }

  static Beyond argument() {
    return new Beyond(true);
  }

  boolean isArgument() {
    return isArgument;
  }
}
