package org.starl.lang.prove;

/** Ctrl-C has ended a search of Z3, which has taken the signal: this process knows nothing of it. */
public final class Interrupted extends RuntimeException {

  private static final long serialVersionUID = 1;

  Interrupted() {
    super("interrupted");
  }
}
