package org.starl.lang.eval;

/** A number or a list is beyond the bounds of the run. */
public final class Beyond extends RuntimeException {

  private static final long serialVersionUID = 1L;

  Beyond() {
    super("beyond the bounds", null, false, false);
  }
}
