package org.starl.lang.read;

/** Leaves a part of a source whose error has been told, so that the next part is read. */
final class Wrong extends RuntimeException {

  private static final long serialVersionUID = 1L;

  Wrong() {
    super("told", null, false, false);
  }
}
