package org.starl.lang.prove;

/** Z3 does not run on this machine; the message says why, on one line. */
public final class NoSolver extends RuntimeException {

  private static final long serialVersionUID = 1L;

  NoSolver(Throwable cause) {
    super(
        "Z3's native library cannot be loaded here ("
            + String.valueOf(cause.getMessage()).lines().findFirst().orElse("")
            + ")",
        cause);
  }
}
