package org.starl.cli;

/** What the command line's exit status says. */
final class ExitStatus {

  static final int GOOD = 0;
  static final int VIOLATED = 1;
  static final int BAD_INPUT = 2;
  static final int LACKING = 3;

  private ExitStatus() {}
}
