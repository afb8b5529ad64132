package org.starl.cli;

import java.io.PrintWriter;
import picocli.CommandLine.Help.Ansi;

/** Tells how far long work is: a bar on a terminal, now and then a plain line elsewhere. */
final class ProgressLine {

  private static final int BAR_WIDTH = 40;
  private static final int PLAIN_LINES = 10;

  private final PrintWriter err;
  private final boolean isTerminal = Ansi.AUTO.enabled();
  private long shownTenths;
  private boolean drawn;

  ProgressLine(PrintWriter err) {
    this.err = err;
  }

  void show(long finished, long planned, long bad) {
    String text = finished + " of " + planned + " runs, " + bad + " bad";
    if (isTerminal) {
      int filled = (int) (finished * BAR_WIDTH / planned);
      err.print("\r[" + "#".repeat(filled) + ".".repeat(BAR_WIDTH - filled) + "] " + text);
      err.flush();
      drawn = true;
    } else {
      long tenths = finished * PLAIN_LINES / planned;
      if (tenths > shownTenths) {
        shownTenths = tenths;
        err.println(text);
      }
    }
  }

  void end() {
    if (drawn) {
      err.println();
    }
  }
}
