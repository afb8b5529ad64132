package org.starl.input;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** The quantities that {@link Quantities} reads, as portable regular expressions. */
public enum Quantity {
  /** {@link Quantities#number}. */
  NUMBER("", Double.POSITIVE_INFINITY),
  /** {@link Quantities#probability}: from 0 to 1. */
  PROBABILITY("", 1),
  /** {@link Quantities#durationNs}. */
  DURATION(anyOf(Quantities.durationUnits()), 0),
  /** {@link Quantities#distanceMm}. */
  DISTANCE(anyOf(Quantities.distanceUnits()) + "?", Quantities.LONGEST_MM),
  /** {@link Quantities#speedMmPerS}. */
  SPEED(anyOf(Quantities.distanceUnits()) + "?(/s)?", Quantities.LONGEST_MM),
  /** {@link Quantities#angleRad}. */
  ANGLE("(deg|rad)", 0),
  /** {@link Quantities#rateHz}. */
  RATE("/\\s*" + anyOf(Quantities.rateUnits()), -1);

  private final String unit;
  private final double mostWithoutUnit;

  Quantity(String unit, double mostWithoutUnit) {
    this.unit = unit;
    this.mostWithoutUnit = mostWithoutUnit;
  }

  /**
   * The greatest number without a unit; 0 if only 0 needs no unit, below 0 if every number needs
   * one.
   */
  public double mostWithoutUnit() {
    return mostWithoutUnit;
  }

  /**
   * The value of a text in this quantity's unit: mm, mm/s, ns, rad, 1/s.
   *
   * @throws BadInput if the text is no value
   */
  public double value(String text) {
    return switch (this) {
      case NUMBER -> Quantities.number(text);
      case PROBABILITY -> Quantities.probability(text);
      case DURATION -> Quantities.durationNs(text);
      case DISTANCE -> Quantities.distanceMm(text);
      case SPEED -> Quantities.speedMmPerS(text);
      case ANGLE -> Quantities.angleRad(text);
      case RATE -> Quantities.rateHz(text);
    };
  }

  /** Matches every text of a value, as a whole. */
  public String pattern() {
    String bareZero = mostWithoutUnit != 0 ? "" : "|0+(\\.0+)?";
    return "^\\s*(\\+?" + Quantities.NUMBER + "\\s*" + unit + bareZero + ")\\s*$";
  }

  /** Matches every text of a value above 0, as a whole: some digit is not 0. */
  public String patternAbove0() {
    return "^(?=[^1-9]*[1-9])\\s*\\+?" + Quantities.NUMBER + "\\s*" + unit + "\\s*$";
  }

  private static String anyOf(Collection<String> units) {
    List<String> words = new ArrayList<>(units);
    words.remove("");
    return "(" + String.join("|", words) + ")";
  }
}
