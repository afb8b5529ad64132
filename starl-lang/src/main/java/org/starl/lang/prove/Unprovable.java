package org.starl.lang.prove;

/** A source has something that is not translated; the message says what. */
public final class Unprovable extends RuntimeException {

  private static final long serialVersionUID = 1L;

  Unprovable(String message) {
    super(message);
  }
}
