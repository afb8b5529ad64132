package org.starl.cli.campaign;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.Node;

/**
 * A setting or parameter of a sweep, and its values: a list, or a range between two numbers with one
 * unit.
 *
 * @param listed the values of a grid; empty for a range without a number of values
 * @param range null for a list
 */
public record SweptKey(String key, int line, List<String> listed, @Nullable Range range) {

  private static final int MOST_VALUES = 1_000;

  public static final String NUMBER = "(-?\\d{1,12}(?:\\.\\d{1,9})?)";
  private static final Pattern RANGE =
      Pattern.compile(
          NUMBER + "([A-Za-z/%]*) *\\.\\. *" + NUMBER + "([A-Za-z/%]*)(?: +in +(\\d{1,4}))?");

  private static final String EXPECTED =
      "expected a list such as [0, 0.1, 0.3], or a range such as 4/min..20/min in 5";

  /**
   * A range. If both ends are whole numbers, so are its samples; else these have three decimals more
   * than the ends.
   */
  record Range(BigDecimal low, BigDecimal high, String unit) {

    /** The value at {@code share} of the way from the low end, from 0 to 1. */
    private String at(double share, int scale) {
      BigDecimal value = low.add(high.subtract(low).multiply(BigDecimal.valueOf(share)));
      BigDecimal rounded = value.setScale(scale, RoundingMode.HALF_UP).stripTrailingZeros();
      return rounded.toPlainString() + unit;
    }

    private int decimals() {
      return Math.max(low.scale(), high.scale());
    }
  }

  /**
   * @throws BadInput naming the line and the value
   */
  static SweptKey of(String file, String key, Node node) {
    if (node instanceof Node.Listing list && !list.items().isEmpty()) {
      List<String> values = new ArrayList<>();
      for (Node item : list.items()) {
        if (!(item instanceof Node.Text text) || text.value().isEmpty()) {
          throw BadInput.at(
              file, item.line(), key + ": " + item.shown() + ": expected a list of single values");
        }
        values.add(text.value());
      }
      return new SweptKey(key, node.line(), values, null);
    }
    String text = node instanceof Node.Text written ? written.value() : "";
    Matcher matcher = RANGE.matcher(text.strip());
    if (matcher.matches() && isUnitOfBoth(matcher.group(2), matcher.group(4))) {
      BigDecimal low = new BigDecimal(matcher.group(1));
      BigDecimal high = new BigDecimal(matcher.group(3));
      int count = matcher.group(5) == null ? 0 : Integer.parseInt(matcher.group(5));
      if (low.compareTo(high) < 0 && count != 1 && count <= MOST_VALUES) {
        Range range = new Range(low, high, matcher.group(4));
        return new SweptKey(key, node.line(), spaced(range, count), range);
      }
    }
    throw BadInput.at(file, node.line(), key + ": " + node.shown() + ": " + EXPECTED);
  }

  /** {@code 4..20/min} too: the unit of the high end is that of both. */
  private static boolean isUnitOfBoth(String low, String high) {
    return low.isEmpty() || low.equals(high);
  }

  private static List<String> spaced(Range range, int count) {
    List<String> values = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      values.add(range.at(i / (count - 1.0), range.decimals() + 3));
    }
    return values;
  }

  /** The value of a sample, at {@code share} of all values: from 0, below 1. */
  String at(double share) {
    if (range == null) {
      return listed.get((int) (share * listed.size()));
    }
    int decimals = range.decimals();
    return range.at(share, decimals == 0 ? 0 : decimals + 3);
  }
}
