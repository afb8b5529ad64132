package org.starl.cli;

import org.starl.lang.verdict.Verdict;

/** The exit statuses of the command line. */
final class ExitStatus {

  static final int GOOD = 0;
  static final int VIOLATED = 1;
  static final int BAD_INPUT = 2;
  static final int MISSING_DEPENDENCY = 3;
  static final int NOT_DECIDED = 4;

  private ExitStatus() {}

  static int of(Verdict verdict) {
    return switch (verdict) {
      case HOLDS -> GOOD;
      case NOT_DECIDED -> NOT_DECIDED;
      case VIOLATED -> VIOLATED;
    };
  }
}
