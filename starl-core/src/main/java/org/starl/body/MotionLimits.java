package org.starl.body;

/** Range checks of {@link MotionParameters}; an error names the parameter and what was expected. */
final class MotionLimits {

  private MotionLimits() {}

  static void positive(String name, double value) {
    check(value > 0 && Double.isFinite(value), name, value, "above 0");
  }

  static void notNegative(String name, double value) {
    check(value >= 0 && Double.isFinite(value), name, value, "at least 0");
  }

  static void positive(String name, long value) {
    check(value > 0, name, (double) value, "above 0");
  }

  static void notNegative(String name, long value) {
    check(value >= 0, name, (double) value, "at least 0");
  }

  static void ordered(String names, long smaller, long larger) {
    ordered(names, (double) smaller, (double) larger);
  }

  static void below(String name, double value, double limit) {
    check(value < limit, name, value, "below " + limit);
  }

  static void ordered(String names, double smaller, double larger) {
    if (!(smaller <= larger) || !Double.isFinite(larger)) {
      throw new IllegalArgumentException(
          names + " " + smaller + " and " + larger + ": expected the smaller one first");
    }
  }

  private static void check(boolean holds, String name, double value, String expected) {
    if (!holds) {
      throw new IllegalArgumentException(name + " " + value + ": expected " + expected);
    }
  }
}
