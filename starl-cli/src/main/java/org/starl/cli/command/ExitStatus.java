package org.starl.cli.command;

import org.starl.lang.verdict.Verdict;

/** The exit statuses of the command line. */
public final class ExitStatus {

  public static final int GOOD = 0;
  public static final int VIOLATED = 1;
  public static final int BAD_INPUT = 2;
  public static final int MISSING_DEPENDENCY = 3;
  public static final int NOT_DECIDED = 4;

  private ExitStatus() {}

  public static int of(Verdict verdict) {
    return switch (verdict) {
      case HOLDS -> GOOD;
      case NOT_DECIDED -> NOT_DECIDED;
      case VIOLATED -> VIOLATED;
    };
  }
}
