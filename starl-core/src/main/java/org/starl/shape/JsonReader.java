package org.starl.shape;

import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.id.RobotId;

/**
 * Reads one line of JSON from left to right; anything unexpected is a {@link
 * JsonFormatException}. Methods with a {@code key} read that text first.
 *
 * <p>Hand-written, because a line must be exactly as {@link JsonWriter} wrote it (order of keys,
 * number of decimals, no white space) and errors name the column; a parser over jackson-core would
 * need the same checks and gives no speed: both read about 550 MB/s on one core (trace of an
 * intersection run).
 */
public final class JsonReader {

  private static final int SHOWN = 24;
  private static final int MAX_EXACT_DIGITS = 15;

  private static final String SCALAR = "+-.0123456789Eaeflnrstu";

  private final String file;
  private final long lineNumber;
  private final String line;
  private int position;

  /**
   * @param file the source's name in errors
   */
  public JsonReader(String file, long lineNumber, String line) {
    this.file = file;
    this.lineNumber = lineNumber;
    this.line = line;
  }

  /** An error at the current position. */
  public JsonFormatException expected(String what) {
    return at(position, what);
  }

  /**
   * An error about {@code value}, which was read just now and is unknown in this version of the
   * format.
   */
  public JsonFormatException unknown(String what, String value) {
    return new JsonFormatException(
        file, lineNumber, "expected a known " + what + ", found " + printable(value));
  }

  /** Reads {@code text}, which must be next. */
  public void expect(String text) throws JsonFormatException {
    if (!line.startsWith(text, position)) {
      throw expected(text);
    }
    position += text.length();
  }

  /**
   * Reads {@code text} if it is next.
   *
   * @return whether it was
   */
  public boolean take(String text) {
    boolean stands = line.startsWith(text, position);
    if (stands) {
      position += text.length();
    }
    return stands;
  }

  /** Reads the end of the JSON object and of the line. */
  public void expectEndOfObject() throws JsonFormatException {
    expect("}");
    expectEnd();
  }

  /** Reads the end of the line. */
  public void expectEnd() throws JsonFormatException {
    if (position != line.length()) {
      throw expected("the end of the line");
    }
  }

  /** Reads an integer of 64 bits. */
  public long number(String key) throws JsonFormatException {
    expect(key);
    int start = position;
    take("-");
    digits();
    try {
      return Long.parseLong(line.substring(start, position));
    } catch (NumberFormatException e) {
      throw at(start, "an integer of at most 64 bits");
    }
  }

  /** Reads an integer of 32 bits. */
  public int smallNumber(String key) throws JsonFormatException {
    expect(key);
    int start = position;
    long value = number("");
    if (value != (int) value) {
      throw at(start, "an integer of at most 32 bits");
    }
    return (int) value;
  }

  /** Reads a number as {@link JsonWriter#number(double)} writes it. */
  public double real() throws JsonFormatException {
    int start = position;
    boolean isFinite = !line.startsWith("\"", position);
    if (!isFinite) {
      string();
    }
    while (position < line.length() && "+-.0123456789E".indexOf(line.charAt(position)) >= 0) {
      position++;
    }
    int quote = isFinite ? 0 : 1;
    try {
      double value = Double.parseDouble(line.substring(start + quote, position - quote));
      if (isFinite == Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      throw at(start, "a number");
    }
    throw at(start, "a number");
  }

  /** Reads one value of any kind, and returns its text. */
  public String value() throws JsonFormatException {
    int start = position;
    int depth = 0;
    do {
      char c = position < line.length() ? line.charAt(position) : ' ';
      switch (c) {
        case '"' -> string();
        case '{', '[' -> {
          depth++;
          position++;
        }
        case '}', ']' -> {
          depth--;
          position++;
        }
        case ',', ':' -> position++;
        default -> scalar(start);
      }
    } while (depth > 0);
    if (depth < 0 || ",:".indexOf(line.charAt(position - 1)) >= 0) {
      throw at(start, "a JSON value");
    }
    return line.substring(start, position);
  }

  /** Reads a number, true, false or null. */
  private void scalar(int start) throws JsonFormatException {
    int from = position;
    while (position < line.length() && SCALAR.indexOf(line.charAt(position)) >= 0) {
      position++;
    }
    if (position == from) {
      throw at(start, "a JSON value");
    }
  }

  /** An error at the current position, for a value that was just read and is not allowed. */
  public JsonFormatException refused(IllegalArgumentException cause) {
    return new JsonFormatException(
        file,
        lineNumber,
        "column " + position + ": " + printable(String.valueOf(cause.getMessage())));
  }

  /** Reads a number with exactly {@code decimals} decimals. */
  public double decimal(String key, int decimals) throws JsonFormatException {
    expect(key);
    int start = position;
    boolean negative = take("-");
    int from = position;
    digits();
    int point = position;
    boolean hasFraction = take(".");
    if (!hasFraction || digits() != decimals) {
      throw at(start, "a number with " + decimals + " decimals");
    }
    if (position - from - 1 > MAX_EXACT_DIGITS) {
      double value = Double.parseDouble(line.substring(start, position));
      if (!Double.isFinite(value)) {
        throw at(start, "a number of at most 308 digits");
      }
      return value;
    }
    long units = 0;
    for (int i = from; i < position; i++) {
      if (i != point) {
        units = 10 * units + (line.charAt(i) - '0');
      }
    }
    return Decimals.fromUnits(negative ? -units : units, decimals);
  }

  /** Reads a string. */
  public String text(String key) throws JsonFormatException {
    expect(key);
    return string();
  }

  private String string() throws JsonFormatException {
    int start = position;
    if (!take("\"")) {
      throw expected("a string");
    }
    int plainEnd = position;
    while (plainEnd < line.length() && isPlain(line.charAt(plainEnd))) {
      plainEnd++;
    }
    if (line.startsWith("\"", plainEnd)) {
      String plain = line.substring(position, plainEnd);
      position = plainEnd + 1;
      return plain;
    }
    StringBuilder text = new StringBuilder(line.length() - position);
    while (position < line.length()) {
      char c = line.charAt(position);
      if (c == '"') {
        position++;
        return text.toString();
      }
      if (c < 0x20) {
        throw expected("an escape in place of a control character");
      }
      position++;
      text.append(c == '\\' ? escape() : c);
    }
    throw at(start, "a string that ends");
  }

  /** Reads a string that is a robot's name. */
  public String robotName(String key) throws JsonFormatException {
    expect(key);
    int start = position;
    String name = string();
    if (!RobotId.isValid(name)) {
      throw at(start, "a robot's name");
    }
    return name;
  }

  /** Reads an object of strings, in its order; duplicate keys are refused. */
  public Map<String, String> stringMap(String key) throws JsonFormatException {
    expect(key);
    Map<String, String> values = new LinkedHashMap<>();
    expect("{");
    if (!take("}")) {
      do {
        int start = position;
        String name = string();
        expect(":");
        if (values.put(name, string()) != null) {
          throw at(start, "each key once");
        }
      } while (take(","));
      expect("}");
    }
    return values;
  }

  private static boolean isPlain(char c) {
    return c != '"' && c != '\\' && c >= 0x20;
  }

  private char escape() throws JsonFormatException {
    int start = position - 1;
    char kind = position < line.length() ? line.charAt(position) : ' ';
    position++;
    return switch (kind) {
      case '"', '\\', '/' -> kind;
      case 'n' -> '\n';
      case 'r' -> '\r';
      case 't' -> '\t';
      case 'b' -> '\b';
      case 'f' -> '\f';
      case 'u' -> unicode(start);
      default -> throw at(start, "an escape of JSON");
    };
  }

  private char unicode(int start) throws JsonFormatException {
    int value = 0;
    for (int i = 0; i < 4; i++, position++) {
      int digit = position < line.length() ? hexDigit(line.charAt(position)) : -1;
      if (digit < 0) {
        throw at(start, "\\u and four hexadecimal digits");
      }
      value = (value << 4) | digit;
    }
    return (char) value;
  }

  private static int hexDigit(char c) {
    return c < 0x80 ? Character.digit(c, 16) : -1;
  }

  private int digits() throws JsonFormatException {
    int start = position;
    while (position < line.length()
        && line.charAt(position) >= '0'
        && line.charAt(position) <= '9') {
      position++;
    }
    if (position == start) {
      throw expected("a digit");
    }
    return position - start;
  }

  private JsonFormatException at(int place, String what) {
    String rest = line.substring(Math.min(place, line.length()));
    String found =
        rest.isEmpty()
            ? "the end of the line"
            : printable(rest.length() <= SHOWN ? rest : rest.substring(0, SHOWN) + "...");
    return new JsonFormatException(
        file, lineNumber, "column " + (place + 1) + ": expected " + what + ", found " + found);
  }

  // Keeps a message on one line of a terminal, whatever bytes the file holds.
  private static String printable(String text) {
    StringBuilder shown = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      shown.append(Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? '?' : c);
    }
    return shown.toString();
  }
}
