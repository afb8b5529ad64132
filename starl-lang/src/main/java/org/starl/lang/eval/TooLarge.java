package org.starl.lang.eval;

/** A type has too many values at the sizes of the run; its message says which, and what to do. */
public final class TooLarge extends RuntimeException {

  private static final long serialVersionUID = 1L;

  TooLarge(String message) {
    super(message);
  }
}
