package org.starl.cli;

/** The machine lacks something; the message names it, and how to get it. Exit status 3. */
final class Lacking extends RuntimeException {

  private static final long serialVersionUID = 1;

  Lacking(String message) {
    super(message);
  }
}
