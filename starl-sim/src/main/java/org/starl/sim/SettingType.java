package org.starl.sim;

import java.time.Duration;
import java.util.Arrays;
import java.util.function.Function;
import java.util.function.Predicate;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;

/**
 * The type of a setting's values.
 *
 * @param reader throws {@link BadInput} if a text is not a value
 * @param writer writes a text that the reader reads back
 * @param validity whether a value is in range
 * @param expected the text after "expected" for a value out of range
 */
record SettingType<T>(
    Class<T> values,
    Function<String, T> reader,
    Function<T, String> writer,
    Predicate<T> validity,
    String expected,
    Form form) {

  static final SettingType<Double> NUMBER =
      amount(Quantity.NUMBER, false, Quantities::number, Quantities::numberText, "a number");
  static final SettingType<Double> DISTANCE = distance(false);
  static final SettingType<Double> SIZE = distance(true);
  static final SettingType<Double> SPEED =
      amount(Quantity.SPEED, true, Quantities::speedMmPerS, Quantities::speedText, "a speed");
  static final SettingType<Double> ANGLE =
      new SettingType<>(
          Double.class,
          Quantities::angleRad,
          Quantities::angleText,
          value -> value >= 0 && value <= StrictMath.PI,
          "an angle from 0 to 180deg",
          Form.amount(Quantity.ANGLE));
  static final SettingType<Double> PROBABILITY =
      new SettingType<>(
          Double.class,
          Quantities::probability,
          Quantities::numberText,
          value -> value >= 0 && value <= 1,
          "a number from 0 to 1",
          Form.amount(Quantity.PROBABILITY));
  static final SettingType<Duration> DURATION = duration(Duration.ZERO);
  // A shorter period costs a computer more than it has, and no sensor has one.
  static final SettingType<Duration> PERIOD = duration(Duration.ofMillis(1));
  static final SettingType<Boolean> YES_NO =
      unlimited(Boolean.class, Quantities::yesOrNo, String::valueOf, Form.YES_NO);
  static final SettingType<String> TEXT =
      unlimited(String.class, String::strip, text -> text, Form.TEXT);

  static SettingType<Integer> whole(int least) {
    return new SettingType<>(
        Integer.class,
        text -> (int) Quantities.whole(text, least, Integer.MAX_VALUE),
        String::valueOf,
        value -> value >= least,
        "a whole number of at least " + least,
        Form.whole(least, Integer.MAX_VALUE));
  }

  /** A type whose reader alone decides. */
  static <T> SettingType<T> unlimited(
      Class<T> values, Function<String, T> reader, Function<T, String> writer, Form form) {
    return new SettingType<>(values, reader, writer, value -> true, "", form);
  }

  static <E extends Enum<E>> SettingType<E> choice(Class<E> values, Function<String, E> reader) {
    Form form = Form.choice(Arrays.stream(values.getEnumConstants()).map(Enum::toString).toList());
    return unlimited(values, reader, Enum::toString, form);
  }

  private static SettingType<Double> distance(boolean isAboveZero) {
    return amount(
        Quantity.DISTANCE,
        isAboveZero,
        Quantities::distanceMm,
        Quantities::distanceText,
        "a distance");
  }

  private static SettingType<Double> amount(
      Quantity quantity,
      boolean isAboveZero,
      Function<String, Double> reader,
      Function<Double, String> writer,
      String name) {
    return new SettingType<>(
        Double.class,
        reader,
        writer,
        value -> (isAboveZero ? value > 0 : value >= 0) && value < Double.POSITIVE_INFINITY,
        name + (isAboveZero ? " above 0" : " of at least 0"),
        new Form.Amount(quantity, isAboveZero));
  }

  private static SettingType<Duration> duration(Duration least) {
    return new SettingType<>(
        Duration.class,
        text -> Duration.ofNanos(Quantities.durationNs(text)),
        value -> Quantities.durationText(value.toNanos()),
        value -> value.compareTo(least) >= 0,
        "a duration of at least "
            + (least.isZero() ? "0" : Quantities.durationText(least.toNanos())),
        new Form.Amount(Quantity.DURATION, !least.isZero()));
  }
}
