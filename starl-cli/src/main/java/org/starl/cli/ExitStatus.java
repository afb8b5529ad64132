package org.starl.cli;

/** The exit statuses of the command line. */
final class ExitStatus {

  static final int GOOD = 0;
  static final int VIOLATED = 1;
  static final int BAD_INPUT = 2;
  static final int MISSING_DEPENDENCY = 3;

  private ExitStatus() {}
}
