package org.starl.cli.command;

import java.io.PrintWriter;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.function.LongSupplier;
import org.starl.sim.check.Campaign;
import org.starl.time.Time;
import picocli.CommandLine.Help.Ansi;

/**
 * Shows the progress, speed and remaining time of long work: on a terminal as a bar that is
 * redrawn, elsewhere as plain lines: ten, and one after each {@link #QUIET_NS} without one.
 */
public final class ProgressLine implements Campaign.Progress {

  /** A seed that runs longer is named: its run may never end. */
  private static final long SLOW_NS = 5 * Time.NS_PER_S;

  private static final int BAR_WIDTH = 30;
  private static final int USUAL_COLUMNS = 80;
  private static final int PLAIN_LINES = 10;

  /** Shorter than 10 s by the second in which work that goes on reports again. */
  private static final long QUIET_NS = 9 * Time.NS_PER_S;

  private static final long REDRAW_NS = 100 * Time.NS_PER_MS;

  /** Earlier, the rate would mostly measure the warm-up of the JVM. */
  private static final long RATE_FROM_NS = 2 * Time.NS_PER_S;

  private final PrintWriter err;
  private final String units;
  private final boolean isTerminal;
  private final int columns;
  private final LongSupplier wallNs;
  private final long startNs;
  private final Map<Long, Long> begunNs = new HashMap<>();
  private final Set<Long> slow = new HashSet<>();
  private long drawnNs;
  private long shownTenths;
  private long shownNs;
  private int drawnWidth;
  private volatile String done = "";
  private volatile boolean isStopped;

  /**
   * @param units the units of work, in the plural: {@code runs}
   */
  public ProgressLine(PrintWriter err, String units) {
    this(err, units, Ansi.AUTO.enabled(), columns(), System::nanoTime);
  }

  /**
   * @param columns width of the terminal, at least 2
   * @param wallNs the wall clock
   */
  public ProgressLine(
      PrintWriter err, String units, boolean isTerminal, int columns, LongSupplier wallNs) {
    this.err = err;
    this.units = units;
    this.isTerminal = isTerminal;
    this.columns = columns;
    this.wallNs = wallNs;
    startNs = wallNs.getAsLong();
    drawnNs = startNs - REDRAW_NS;
    shownNs = startNs;
  }

  /** Wall-clock time since the work began. */
  public long elapsedNs() {
    return wallNs.getAsLong() - startNs;
  }

  public void show(long finished, long planned) {
    show(finished, planned, "");
  }

  @Override
  public void advanced(long finished, long planned, long bad) {
    show(finished, planned, ", " + bad + " bad");
  }

  @Override
  public void running(SortedSet<Long> seeds) {
    long nowNs = wallNs.getAsLong();
    begunNs.keySet().retainAll(seeds);
    for (long seed : seeds) {
      Long since = begunNs.putIfAbsent(seed, nowNs);
      if (since != null && nowNs - since >= SLOW_NS && slow.add(seed) && !isStopped) {
        note("seed " + seed + " still runs after 5 s");
      }
    }
  }

  private void show(long finished, long planned, String rest) {
    done = finished + " of " + planned + " " + units;
    if (isStopped) {
      return;
    }
    long nowNs = wallNs.getAsLong();
    boolean isLast = finished == planned;
    if (isTerminal) {
      if (isLast || nowNs - drawnNs >= REDRAW_NS) {
        drawnNs = nowNs;
        draw(bar(finished, planned, text(finished, planned, rest, nowNs)));
      }
      return;
    }
    long tenths = finished * PLAIN_LINES / planned;
    if (tenths > shownTenths || nowNs - shownNs >= QUIET_NS) {
      shownTenths = tenths;
      shownNs = nowNs;
      err.println(text(finished, planned, rest, nowNs));
    }
  }

  /** Work whose end is not known: {@code 1,200,000 states, 300,000 of them to go on from}. */
  public void found(long found, long open) {
    long nowNs = wallNs.getAsLong();
    if (isStopped || nowNs - shownNs < (isTerminal ? REDRAW_NS : QUIET_NS)) {
      return;
    }
    shownNs = nowNs;
    done = "%,d %s, %,d of them to go on from".formatted(found, units, open);
    if (isTerminal) {
      draw(done.substring(0, Math.min(done.length(), columns - 1)));
    } else {
      err.println(done);
    }
  }

  /** Prints a line of its own; on a terminal it takes the bar's place, which is drawn anew below. */
  public void note(String line) {
    if (drawnWidth > 0) {
      draw("");
      err.print("\r");
    }
    err.println(line);
    drawnWidth = 0;
  }

  /** Ends the bar's line, if there is one. May be called repeatedly. */
  public void end() {
    if (drawnWidth > 0) {
      err.println();
      drawnWidth = 0;
    }
  }

  /** Ends the line for good, from another thread; returns what is done, empty if nothing is. */
  String stopped() {
    isStopped = true;
    end();
    return done;
  }

  /** A bar and a text, in one line: the bar is shorter if the terminal is narrow. */
  private String bar(long finished, long planned, String text) {
    int width = Math.min(BAR_WIDTH, columns - 1 - "[] ".length() - text.length());
    if (width <= 0) {
      return text.substring(0, Math.min(text.length(), columns - 1));
    }
    int filled = (int) (finished * width / planned);
    return "[%s%s] %s".formatted("#".repeat(filled), ".".repeat(width - filled), text);
  }

  /** The width of the terminal, which shells tell in COLUMNS if it is exported. */
  public static int columns() {
    String columns = System.getenv().getOrDefault("COLUMNS", "");
    return columns.matches("[1-9]\\d{1,3}") ? Integer.parseInt(columns) : USUAL_COLUMNS;
  }

  /** Overwrites the previous line, which may be longer. */
  private void draw(String line) {
    err.print("\r" + line + " ".repeat(Math.max(0, drawnWidth - line.length())));
    err.flush();
    drawnWidth = line.length();
  }

  private String text(long finished, long planned, String rest, long nowNs) {
    String text = done + rest;
    long elapsedNs = nowNs - startNs;
    if (finished == 0 || elapsedNs < RATE_FROM_NS) {
      return text;
    }
    double perS = finished / Time.seconds(elapsedNs);
    String rate = rate(perS);
    return finished == planned
        ? text + "; " + rate
        : text + "; " + rate + ", " + duration((planned - finished) / perS) + " left";
  }

  private static String rate(double perS) {
    if (perS >= 1) {
      return number(perS) + " per second";
    }
    return perS >= 1.0 / 60 ? number(60 * perS) + " per minute" : number(3600 * perS) + " per hour";
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, value < 10 ? "%.1f" : "%.0f", value);
  }

  private static String duration(double seconds) {
    long s = (long) Math.ceil(seconds);
    if (s < 60) {
      return s + " s";
    }
    return s < 3600 ? s / 60 + " min " + s % 60 + " s" : s / 3600 + " h " + s % 3600 / 60 + " min";
  }
}
