package org.starl.input;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes quantities with units: {@code 100ms}, {@code 3m}, {@code 0.05}. Every reader
 * throws {@link BadInput} with the text and the expected form; the caller adds the place of the text, with
 * {@link #in}.
 *
 * <p>Every command reads some at its start, and the JDK computes large powers when it loads
 * {@link BigDecimal}: so common numbers do without it.
 */
public final class Quantities {

  /** A number without its sign; with as many decimals as {@link #numberText} may write. */
  static final String NUMBER = "[0-9]{1,19}(?:\\.[0-9]{1,400})?";

  private static final Pattern NUMBER_AND_UNIT =
      Pattern.compile("([+-]?" + NUMBER + ")\\s*([a-z]*)");

  private static final Pattern WHOLE = Pattern.compile("[+-]?[0-9]{1,1000}");

  private static final Map<String, Long> NS_PER_UNIT = new LinkedHashMap<>();

  /** The powers of ten. */
  private static final Map<String, Integer> MM_PER_UNIT = new LinkedHashMap<>();

  static {
    NS_PER_UNIT.put("ns", 1L);
    NS_PER_UNIT.put("us", 1_000L);
    NS_PER_UNIT.put("ms", 1_000_000L);
    NS_PER_UNIT.put("s", 1_000_000_000L);
    NS_PER_UNIT.put("min", 60_000_000_000L);
    NS_PER_UNIT.put("h", 3_600_000_000_000L);
    MM_PER_UNIT.put("", 0);
    MM_PER_UNIT.put("mm", 0);
    MM_PER_UNIT.put("cm", 1);
    MM_PER_UNIT.put("m", 3);
  }

  private static final BigInteger LONGEST_NS = BigInteger.valueOf(Long.MAX_VALUE / 4);
  static final double LONGEST_MM = 1e9;

  private Quantities() {}

  static Collection<String> durationUnits() {
    return NS_PER_UNIT.keySet();
  }

  static Collection<String> distanceUnits() {
    return MM_PER_UNIT.keySet();
  }

  /** The units of time in rates. */
  static Collection<String> rateUnits() {
    return NS_PER_UNIT.keySet().stream()
        .filter(Quantities::isRateUnit)
        .collect(Collectors.toList());
  }

  private static boolean isRateUnit(String unit) {
    Long ns = NS_PER_UNIT.get(unit);
    return ns != null && ns >= 1_000_000_000;
  }

  /** A time span of at least 0, in ns: {@code 250us}, {@code 100ms}, {@code 1.5s}, {@code 0}. */
  public static long durationNs(String text) {
    String expected = "a duration with a unit (ns us ms s min h), such as 100ms";
    Matcher matcher = match(text, expected);
    String number = matcher.group(1);
    Long unit = unit(matcher, NS_PER_UNIT);
    if (unit == null) {
      throw notA(text, expected);
    }
    int point = number.indexOf('.');
    BigInteger digits = new BigInteger(number.replace(".", ""));
    BigInteger parts = BigInteger.TEN.pow(point < 0 ? 0 : number.length() - point - 1);
    // Half a ns counts as one.
    BigInteger ns =
        digits.multiply(BigInteger.valueOf(2 * unit)).add(parts).divide(parts.shiftLeft(1));
    if (ns.compareTo(LONGEST_NS) > 0) {
      throw notA(text, "a duration below 70 years");
    }
    return ns.longValue();
  }

  /** The shortest text that {@link #durationNs} reads as {@code ns}: {@code 15ms}. */
  public static String durationText(long ns) {
    if (ns == 0) {
      return "0ms";
    }
    if (ns % 1_000_000_000 == 0) {
      return ns / 1_000_000_000 + "s";
    }
    if (ns % 1_000_000 == 0) {
      return ns / 1_000_000 + "ms";
    }
    return ns % 1_000 == 0 ? ns / 1_000 + "us" : ns + "ns";
  }

  /** A distance of at least 0, in mm: {@code 165}, {@code 20mm}, {@code 2.5cm}, {@code 3m}. */
  public static double distanceMm(String text) {
    String expected = "a distance of at least 0 (mm cm m; without a unit: mm), such as 20mm";
    Matcher matcher = match(text, expected);
    Integer power = unit(matcher, MM_PER_UNIT);
    if (power == null) {
      throw notA(text, expected);
    }
    double mm = Math.abs(Double.parseDouble(matcher.group(1) + "e" + power)); // no -0
    if (mm > LONGEST_MM) {
      throw notA(text, "a distance below 1000 km");
    }
    return mm;
  }

  /** The text that {@link #distanceMm} reads as {@code mm}: {@code 165mm}. */
  public static String distanceText(double mm) {
    return numberText(mm) + "mm";
  }

  /** A speed of at least 0, in mm/s: {@code 500}, {@code 500mm/s}, {@code 0.5m/s}. */
  public static double speedMmPerS(String text) {
    String stripped = text.trim();
    try {
      return distanceMm(
          stripped.endsWith("/s") ? stripped.substring(0, stripped.length() - 2) : stripped);
    } catch (BadInput noDistance) {
      throw notA(text, "a speed of at least 0 (mm/s m/s; without a unit: mm/s)");
    }
  }

  /** The text that {@link #speedMmPerS} reads as {@code mmPerS}: {@code 500mm/s}. */
  public static String speedText(double mmPerS) {
    return distanceText(mmPerS) + "/s";
  }

  /** A number of at least 0 without a unit. */
  public static double number(String text) {
    return numberUpTo(text, Double.POSITIVE_INFINITY, "a number of at least 0, such as 2.5");
  }

  /** A mean rate above 0, in 1/s: {@code 20/min}, {@code 0.5/s}. */
  public static double rateHz(String text) {
    String expected = "a rate above 0 with a unit (/s /min /h), such as 20/min";
    String stripped = text.trim();
    int slash = stripped.indexOf('/');
    String per = slash < 0 ? "" : stripped.substring(slash + 1).trim();
    Long unit = NS_PER_UNIT.get(per);
    if (unit == null || !isRateUnit(per)) {
      throw notA(text, expected);
    }
    Matcher matcher = NUMBER_AND_UNIT.matcher(stripped.substring(0, slash).trim());
    if (!matcher.matches() || !matcher.group(2).isEmpty()) {
      throw notA(text, expected);
    }
    double number = Double.parseDouble(matcher.group(1));
    if (number <= 0) {
      throw notA(text, expected);
    }
    return number * 1e9 / unit;
  }

  /** An angle of at least 0, in radians: {@code 3deg}, {@code 0.05rad}, {@code 0}. */
  public static double angleRad(String text) {
    String expected = "an angle of at least 0 with a unit (deg rad), such as 3deg";
    Matcher matcher = match(text, expected);
    double number = Double.parseDouble(matcher.group(1));
    String unit = matcher.group(2);
    if (number < 0 || (unit.isEmpty() && number != 0)) {
      throw notA(text, expected);
    }
    return switch (unit) {
      case "" -> 0;
      case "rad" -> number;
      case "deg" -> StrictMath.toRadians(number);
      default -> throw notA(text, expected);
    };
  }

  /** The text that {@link #angleRad} reads as {@code rad}: {@code 0.05rad}. */
  public static String angleText(double rad) {
    return numberText(rad) + "rad";
  }

  /** A probability from 0 to 1. */
  public static double probability(String text) {
    return numberUpTo(text, 1, "a probability from 0 to 1, such as 0.05");
  }

  /** A whole number from {@code min} to {@code max}. */
  public static long whole(String text, long min, long max) {
    String trimmed = text.trim();
    BigInteger number = WHOLE.matcher(trimmed).matches() ? new BigInteger(trimmed) : null;
    boolean isTooLarge = number != null && number.compareTo(BigInteger.valueOf(max)) > 0;
    if (number != null && !isTooLarge && number.compareTo(BigInteger.valueOf(min)) >= 0) {
      return number.longValue();
    }
    String expected = "a whole number";
    if (isTooLarge || max < Integer.MAX_VALUE) {
      expected += " from " + min + " to " + max;
    } else if (min > Long.MIN_VALUE) {
      expected += " of at least " + min;
    }
    throw notA(text, expected);
  }

  /** {@code true} or {@code false}. */
  public static boolean yesOrNo(String text) {
    return switch (text.trim()) {
      case "true", "yes", "on" -> true;
      case "false", "no", "off" -> false;
      default -> throw notA(text, "true or false");
    };
  }

  /** The same error after the place of the text: {@code --loss: '2': expected ...}. */
  public static BadInput in(String where, BadInput error) {
    return new BadInput(where + ": " + error.getMessage());
  }

  /** A finite number without an exponent, which every reader here reads back. */
  public static String numberText(double number) {
    double size = Math.abs(number);
    if (size < 1e15 && number == StrictMath.rint(number)) {
      return Long.toString((long) number);
    }
    if (size >= 1e-3 && size < 1e7) { // Java writes it without an exponent
      return Double.toString(number);
    }
    return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
  }

  /** The unit of a number of at least 0; null if there is none or it is not one of these. 0 needs no unit. */
  private static <T> @Nullable T unit(Matcher matcher, Map<String, T> units) {
    double number = Double.parseDouble(matcher.group(1));
    if (number < 0) {
      return null;
    }
    String unit = matcher.group(2);
    return units.get(unit.isEmpty() && number == 0 ? units.keySet().iterator().next() : unit);
  }

  /** At least 0, without a unit. */
  private static double numberUpTo(String text, double most, String expected) {
    Matcher matcher = match(text, expected);
    double number = Double.parseDouble(matcher.group(1));
    if (!matcher.group(2).isEmpty() || number < 0 || number > most) {
      throw notA(text, expected);
    }
    return number;
  }

  private static Matcher match(String text, String expected) {
    Matcher matcher = NUMBER_AND_UNIT.matcher(text.trim());
    if (!matcher.matches()) {
      throw notA(text, expected);
    }
    return matcher;
  }

  /** {@code '2': expected a number from 0 to 1}. */
  static BadInput notA(String text, String expected) {
    return new BadInput(BadInput.quote(text) + ": expected " + expected);
  }
}
