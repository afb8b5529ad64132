package org.starl.input;

import java.util.Arrays;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * One line of a document: its key, its values and their meaning. The reader of the document and
 * its JSON schema both use it.
 *
 * @param <T> the type of its value; {@link Void} for a mapping
 * @param key the text before the colon
 * @param form the values that it takes
 * @param reader gives the value of a text, or null if the text is not one of the form
 * @param meaning one line for people, with the unit of the value
 * @param isNeeded whether the line must be there
 * @param defaultText the value of a missing line; null if there is none, or it depends on others
 */
public record Field<T>(
    String key,
    Form form,
    Function<String, @Nullable T> reader,
    String meaning,
    boolean isNeeded,
    @Nullable String defaultText) {

  /** Double.parseDouble takes more: 0x1p3, 5d, NaN. */
  private static final Pattern DECIMAL =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");

  /** An optional line without a default. */
  public static <T> Field<T> of(
      String key, Form form, String meaning, Function<String, @Nullable T> reader) {
    return new Field<>(key, form, reader, meaning, false, null);
  }

  /** A line with a mapping beneath it. */
  public static Field<Void> mapping(String key, Form form, String meaning) {
    return of(key, form, meaning, text -> null);
  }

  /** @param expected the expected text, for messages */
  public static Field<String> text(String key, String expected, String meaning) {
    return of(key, new Form.Words(expected), meaning, text -> text);
  }

  /**
   * A text that is not blank.
   *
   * @param expected the expected text, for messages
   * @param pattern a regular expression that begins with {@code ^} and ends with {@code $}
   */
  public static Field<String> matching(
      String key, String expected, String pattern, String meaning) {
    Form form = new Form.Words(expected, pattern);
    return of(key, form, meaning, text -> text.matches(pattern) ? text : null);
  }

  public static Field<String> choice(String key, String meaning, String... values) {
    Form.Choice form = new Form.Choice(Arrays.asList(values));
    return of(key, form, meaning, text -> form.values().contains(text) ? text : null);
  }

  public static Field<Boolean> yesNo(String key, String meaning) {
    return of(key, Form.YES_NO, meaning, orNull(Quantities::yesOrNo));
  }

  /** Both ends are included. */
  public static Field<Integer> whole(String key, int least, int most, String meaning) {
    return of(
        key,
        new Form.Whole(least, most),
        meaning,
        orNull(text -> (int) Quantities.whole(text, least, most)));
  }

  /** Any number of 64 bits. */
  public static Field<Long> wholeLong(String key, String meaning) {
    long least = Long.MIN_VALUE;
    long most = Long.MAX_VALUE;
    return of(
        key,
        new Form.Whole(least, most),
        meaning,
        orNull(text -> Quantities.whole(text, least, most)));
  }

  /** Both ends are included. */
  public static Field<Double> decimal(String key, double least, double most, String meaning) {
    return of(
        key,
        new Form.Decimal(least, most),
        meaning,
        text -> {
          double value = DECIMAL.matcher(text).matches() ? Double.parseDouble(text) : Double.NaN;
          return value >= least && value <= most ? value : null;
        });
  }

  /** The same, but the line must be there. */
  public Field<T> needed() {
    return new Field<>(key, form, reader, meaning, true, null);
  }

  /** The same with the value of a missing line. */
  public Field<T> defaultsTo(String text) {
    return new Field<>(key, form, reader, meaning, false, text);
  }

  /** A reader that returns null where {@code reader} refuses the text. */
  private static <T> Function<String, @Nullable T> orNull(Function<String, T> reader) {
    return text -> {
      try {
        return reader.apply(text);
      } catch (BadInput refused) {
        return null;
      }
    };
  }
}
