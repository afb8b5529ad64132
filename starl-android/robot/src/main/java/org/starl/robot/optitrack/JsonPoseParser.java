package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * Reads one line of the JSON feed: one object of RFC 8259 whose keys are those below, in any order,
 * each at most once, and whose numbers are finite and within bounds. Never throws.
 */
final class JsonPoseParser {

  /** No line is longer. */
  static final int MAX_BYTES = 1024;

  private static final String[] KEYS = {
    "robot", "xMm", "yMm", "headingRad", "errorMm", "atNs", "errorRad"
  };
  private static final int ROBOT = 0;
  private static final int X = 1;
  private static final int Y = 2;
  private static final int HEADING = 3;
  private static final int ERROR = 4;
  private static final int AT = 5;
  private static final int ERROR_RAD = 6;

  /** As many keys as must be there: all but the last. */
  private static final int REQUIRED = 6;

  private static final int MAX_NUMBER_CHARS = 40;
  private static final double LARGEST_MM = 1e7;
  private static final double LARGEST_RAD = 1e3;
  private static final long LARGEST_NS = 4_000_000_000_000_000_000L;

  private final String line;
  private final double[] numbers = new double[KEYS.length];
  private final boolean[] isThere = new boolean[KEYS.length];
  private String robot = "";
  private long atNs;
  private int at;
  private String problem = "";

  private JsonPoseParser(String line) {
    this.line = line;
  }

  /** A pose, or why there is none. */
  record Result(@Nullable JsonPose pose, String problem) {}

  static Result parse(byte[] bytes, int length) {
    if (length > MAX_BYTES) {
      return new Result(null, length + " bytes: expected at most " + MAX_BYTES);
    }
    // Each byte is a character of its own: what is not ASCII is not expected anywhere.
    JsonPoseParser parser =
        new JsonPoseParser(new String(bytes, 0, length, StandardCharsets.ISO_8859_1));
    JsonPose pose = parser.object();
    return new Result(parser.problem.isEmpty() ? pose : null, parser.problem);
  }

  private @Nullable JsonPose object() {
    expect('{');
    do {
      entry();
    } while (problem.isEmpty() && take(','));
    expect('}');
    space();
    if (problem.isEmpty() && at < line.length()) {
      expected("the end of the line");
    }
    for (int key = 0; key < REQUIRED && problem.isEmpty(); key++) {
      if (!isThere[key]) {
        problem = "no " + KEYS[key];
      }
    }
    if (!problem.isEmpty()) {
      return null;
    }
    return new JsonPose(
        robot,
        new Pose(numbers[X], numbers[Y], Angles.normalize(numbers[HEADING])),
        numbers[ERROR],
        numbers[ERROR_RAD],
        atNs);
  }

  private void entry() {
    int start = at;
    String name = string();
    int key = KEYS.length - 1;
    while (key >= 0 && !KEYS[key].equals(name)) {
      key--;
    }
    if (problem.isEmpty() && (key < 0 || isThere[key])) {
      at = start;
      expected(key < 0 ? "a known key" : "each key once");
    }
    expect(':');
    if (!problem.isEmpty()) {
      return;
    }
    isThere[key] = true;
    switch (key) {
      case ROBOT -> {
        robot = string();
        if (problem.isEmpty() && !RobotId.isValid(robot)) {
          expected("a robot's name before this");
        }
      }
      case AT -> atNs = wholeNumber();
      case HEADING -> numbers[key] = number(-LARGEST_RAD, LARGEST_RAD);
      case ERROR -> numbers[key] = number(0, LARGEST_MM);
      case ERROR_RAD -> numbers[key] = number(0, LARGEST_RAD);
      default -> numbers[key] = number(-LARGEST_MM, LARGEST_MM);
    }
  }

  /** Names and keys need no escapes, and may have none. */
  private String string() {
    expect('"');
    int start = at;
    while (at < line.length() && isPlain(line.charAt(at))) {
      at++;
    }
    String text = line.substring(start, at);
    if (problem.isEmpty() && !(at < line.length() && line.charAt(at) == '"')) {
      expected("ASCII without escapes, and a quote at its end");
    }
    if (!problem.isEmpty()) {
      return "";
    }
    at++;
    return text;
  }

  private double number(double least, double most) {
    int start = numberStart();
    digits(true);
    if (at < line.length() && line.charAt(at) == '.') {
      at++;
      digits(false);
    }
    if (at < line.length() && (line.charAt(at) == 'e' || line.charAt(at) == 'E')) {
      at++;
      if (at < line.length() && (line.charAt(at) == '+' || line.charAt(at) == '-')) {
        at++;
      }
      digits(false);
    }
    if (!isNumber(start)) {
      return 0;
    }
    double value = Double.parseDouble(line.substring(start, at));
    if (value < least || value > most) {
      at = start;
      expected("a number from " + least + " to " + most);
    }
    return value;
  }

  private long wholeNumber() {
    int start = numberStart();
    digits(true);
    int maxDigits = 19;
    if (!isNumber(start)) {
      return 0;
    }
    long value = 0;
    boolean isNegative = line.charAt(start) == '-';
    int from = isNegative ? start + 1 : start;
    boolean fits = at - from < maxDigits;
    for (int i = from; i < at && fits; i++) {
      value = 10 * value + (line.charAt(i) - '0');
    }
    if (!fits || value > LARGEST_NS) {
      at = start;
      expected("a whole number of up to 18 digits");
    }
    return isNegative ? -value : value;
  }

  private int numberStart() {
    space();
    int start = at;
    if (at < line.length() && line.charAt(at) == '-') {
      at++;
    }
    return start;
  }

  private boolean isNumber(int start) {
    if (problem.isEmpty() && at - start > MAX_NUMBER_CHARS) {
      at = start;
      expected("a number of at most " + MAX_NUMBER_CHARS + " characters");
    }
    return problem.isEmpty();
  }

  private void digits(boolean isWholePart) {
    int start = at;
    while (at < line.length() && line.charAt(at) >= '0' && line.charAt(at) <= '9') {
      at++;
    }
    if (at == start || (isWholePart && at - start > 1 && line.charAt(start) == '0')) {
      expected(at == start ? "a digit" : "a number without leading zeros before this");
    }
  }

  private static boolean isPlain(char c) {
    return c >= 0x20 && c < 0x7f && c != '"' && c != '\\';
  }

  private void space() {
    while (at < line.length() && " \t\r\n".indexOf(line.charAt(at)) >= 0) {
      at++;
    }
  }

  private boolean take(char c) {
    space();
    boolean stands = at < line.length() && line.charAt(at) == c;
    at += stands ? 1 : 0;
    return stands;
  }

  private void expect(char c) {
    if (!take(c)) {
      expected("'" + c + "'");
    }
  }

  /** The first problem counts. */
  private void expected(String what) {
    if (problem.isEmpty()) {
      problem = "column " + (Math.min(at, line.length()) + 1) + ": expected " + what;
    }
  }
}
