package org.starl.cli.report;

import java.util.Locale;

/** Formats numbers for readers. */
final class NumberFormats {

  /** Between groups of three digits: a narrow no-break space. */
  private static final char GROUP = '\u202F';

  /** Between a number and its unit: a no-break space. */
  private static final char GAP = '\u00A0';

  private NumberFormats() {}

  /** {@code 12 345}. */
  static String count(long value) {
    return String.format(Locale.ROOT, "%,d", value).replace(',', GROUP);
  }

  /** {@code 1 run}, {@code 12 runs}. */
  static String count(long value, String one) {
    return count(value) + GAP + one + (value == 1 ? "" : "s");
  }

  /** Three significant digits, without trailing zeros after the point. */
  static String number(double value) {
    if (value == Math.rint(value) && Math.abs(value) < 1e15) {
      return count((long) value);
    }
    double size = Math.abs(value);
    int digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    String text = String.format(Locale.ROOT, "%,." + digits + "f", value).replace(',', GROUP);
    return digits == 0 ? text : text.replaceAll("\\.?0+$", "");
  }

  /** A measured value, to one decimal, or two or three below 1. */
  static String measured(double value) {
    if (value == 0 || value >= 1000) {
      return count(Math.round(value));
    }
    int digits = value >= 0.95 ? 1 : value >= 0.095 ? 2 : 3;
    return String.format(Locale.ROOT, "%." + digits + "f", value);
  }

  /** {@code 7.0 s}. */
  static String measured(String unit, double value) {
    return unit.isEmpty() ? measured(value) : measured(value) + GAP + unit;
  }

  /** {@code 5 s}, as {@link #number(double)}. */
  static String number(String unit, double value) {
    return unit.isEmpty() ? number(value) : number(value) + GAP + unit;
  }

  /** {@code 3.2 %}. Only an exact 0 or 100 is written as such. */
  static String percent(long part, long whole) {
    if (whole == 0 || part == 0 || part == whole) {
      return (part == 0 ? "0" : "100") + GAP + "%";
    }
    double percent = Math.min(99.9, Math.max(0.1, 100.0 * part / whole));
    return String.format(Locale.ROOT, "%.1f", percent) + GAP + "%";
  }

  static String capitalized(String text) {
    return text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
