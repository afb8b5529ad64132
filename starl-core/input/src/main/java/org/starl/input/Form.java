package org.starl.input;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The values that a setting, a parameter or a line of a document takes: for error messages and for
 * JSON schemas. {@link #value} reads them; another reader may refuse a value that the form allows.
 */
public sealed interface Form {

  /** Any text on one line. */
  Form TEXT = new Text("");

  /** True or false. */
  Form YES_NO = new YesNo();

  /** Faults, one or several. */
  Form FAULTS = new Faults();

  /** A whole number, both ends included. */
  record Whole(long least, long most) implements Form {}

  /** A decimal number, both ends included. */
  record Decimal(double least, double most) implements Form {}

  /** A quantity with its unit, at least 0; above 0 if {@code isAboveZero}. */
  record Amount(Quantity quantity, boolean isAboveZero) implements Form {}

  /**
   * A quantity with its unit, both ends included.
   *
   * @param least and {@code most}: values of the quantity, as text
   */
  record Between(Quantity quantity, String least, String most) implements Form {}

  /** One of these words. */
  record Choice(List<String> values) implements Form {
    public Choice {
      values = List.copyOf(values);
    }
  }

  /** {@code true yes on}, or {@code false no off}. */
  record YesNo() implements Form {}

  /** A text that matches a regular expression as a whole; any text if the expression is empty. */
  record Text(String pattern) implements Form {}

  /**
   * A text that is not blank.
   *
   * @param expected the text after "expected" in messages
   * @param pattern a regular expression that a part of the text matches
   */
  record Words(String expected, String pattern) implements Form {

    /** The pattern of any text that is not blank. */
    public static final String ANY = "\\S";

    /** Any text that is not blank. */
    public Words(String expected) {
      this(expected, ANY);
    }
  }

  /** Faults in their grammar. */
  record Faults() implements Form {}

  /** A number of an IPv4 address, as a regular expression. */
  String OCTET = "(25[0-5]|2[0-4]\\d|1\\d\\d|[1-9]?\\d)";

  /**
   * A name, or a whole IPv4 address, as a regular expression; no colon and no bracket is in it. Java reads
   * 10.1 as 10.0.0.1.
   */
  String HOST = "(" + OCTET + "(\\." + OCTET + "){3}|(?![-+]?[\\d.]+(:|\\s|$))[^\\s:\\[\\]]+)";

  /**
   * {@code HOST:PORT} or {@code [IPV6]:PORT}.
   *
   * @param needsPort false if HOST alone is enough
   */
  record Address(boolean needsPort) implements Form {}

  /** The path of a device, or {@code tcp:HOST:PORT}. */
  record Port() implements Form {}

  /**
   * A mapping with these fields.
   *
   * @param expected an example, for messages
   */
  record Lines(String expected, List<Field<?>> fields) implements Form {
    public Lines {
      fields = List.copyOf(fields);
    }
  }

  /**
   * A mapping with one field, {@code by}, that decides which other fields it has.
   *
   * @param by takes a {@link Choice} of the kinds; if it is missing, its default decides
   * @param kinds the other fields of each kind, in the order of the choice
   */
  record Kinds(String expected, Field<String> by, Map<String, List<Field<?>>> kinds)
      implements Form {}

  /** A mapping of robots' names to mappings of the form {@code each}. */
  record Named(String expected, Form each) implements Form {}

  /** A mapping of the app's parameters and settings to one value each. */
  record Parameters(String expected) implements Form {}

  /**
   * The text after "expected" in a message about {@code form}. Static, because a default method
   * would let the constants above initialize this type and its records in either order.
   */
  static String expected(Form form) {
    return switch (form) {
      case Whole whole -> "a whole number from " + whole.least() + " to " + whole.most();
      case Decimal decimal -> "a number from " + decimal.least() + " to " + decimal.most();
      case Amount amount ->
          "a "
              + amount.quantity().name().toLowerCase(Locale.ROOT)
              + (amount.isAboveZero() ? " above 0" : "");
      case Between between ->
          String.format(
              "a %s from %s to %s",
              between.quantity().name().toLowerCase(Locale.ROOT), between.least(), between.most());
      case Choice choice -> "one of " + String.join(", ", choice.values());
      case YesNo yesNo -> "one of true, false, yes, no, on, off";
      case Text text -> "a text";
      case Words words -> words.expected();
      case Faults faults -> "faults";
      case Address address -> address.needsPort() ? "HOST:PORT" : "HOST or HOST:PORT";
      case Port port -> "a device or tcp:HOST:PORT";
      case Lines lines -> lines.expected();
      case Kinds kinds -> kinds.expected();
      case Named named -> named.expected();
      case Parameters parameters -> parameters.expected();
    };
  }

  /**
   * The value of a text: a {@link Long}, a {@link Double}, for a quantity in its unit (mm, mm/s, ns,
   * rad, 1/s), a {@link Boolean} or the text itself, stripped for a {@link Choice}.
   *
   * @throws BadInput if the text is no value of the form
   */
  static Object value(Form form, String text) {
    return switch (form) {
      case Whole whole -> Quantities.whole(text, whole.least(), whole.most());
      case Decimal decimal -> {
        double value = Quantities.number(text);
        yield within(form, text, value, decimal.least(), decimal.most());
      }
      case Amount amount -> {
        double value = amount.quantity().value(text);
        double least = amount.isAboveZero() ? Double.MIN_VALUE : 0;
        yield within(form, text, value, least, Double.POSITIVE_INFINITY);
      }
      case Between between -> {
        Quantity quantity = between.quantity();
        double value = quantity.value(text);
        yield within(
            form, text, value, quantity.value(between.least()), quantity.value(between.most()));
      }
      case Choice choice -> {
        if (!choice.values().contains(text.trim())) {
          throw Quantities.notA(text, expected(form));
        }
        yield text.trim();
      }
      case YesNo yesNo -> Quantities.yesOrNo(text);
      default -> text;
    };
  }

  private static double within(Form form, String text, double value, double least, double most) {
    if (value < least || value > most) {
      throw Quantities.notA(text, expected(form));
    }
    return value;
  }

  static Form whole(long least, long most) {
    return new Whole(least, most);
  }

  /** A quantity of at least 0. */
  static Form amount(Quantity quantity) {
    return new Amount(quantity, false);
  }

  /** A quantity above 0. */
  static Form above0(Quantity quantity) {
    return new Amount(quantity, true);
  }

  /** A quantity from {@code least} to {@code most}, as text. */
  static Form between(Quantity quantity, String least, String most) {
    return new Between(quantity, least, most);
  }

  static Form choice(List<String> values) {
    return new Choice(values);
  }
}
