package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.input.Quantities;

/** A parsed {@code name(a,b,key=c)}: positional and keyed arguments, each of which must be used. */
final class FaultArguments {

  private static final Pattern FORM = Pattern.compile("\\s*([a-z]+)\\s*(?:\\((.*)\\))?\\s*");
  private static final Pattern KEYED = Pattern.compile("\\s*([a-z]+)\\s*=(.*)");

  private final String text;
  private final String name;
  private final List<String> placed = new ArrayList<>();
  private final Map<String, String> keyed = new LinkedHashMap<>();
  private final Set<String> asked = new LinkedHashSet<>();
  private final List<String> canonical = new ArrayList<>();
  private final List<RobotSelector> named = new ArrayList<>();
  private RobotSelector robots = RobotSelector.ALL;
  private String usage = "";
  private int used;

  private FaultArguments(String text, String name) {
    this.text = text;
    this.name = name;
  }

  /** @throws BadInput if {@code text} does not have this form */
  static FaultArguments parse(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      throw new BadInput(
          BadInput.quote(text) + ": expected a fault, such as crash(bot2,at=12s,restart=5s)");
    }
    FaultArguments call = new FaultArguments(text.strip(), form.group(1));
    String inside = form.group(2);
    if (inside != null && !inside.isBlank()) {
      call.split(inside, ',').forEach(call::add);
    }
    return call;
  }

  private void add(String argument) {
    Matcher pair = KEYED.matcher(argument);
    if (!pair.matches()) {
      placed.add(argument.strip());
      return;
    }
    String value = pair.group(2).strip();
    // Senders are names; times begin with a digit.
    boolean isTime = !value.isEmpty() && Character.isDigit(value.charAt(0));
    String key = pair.group(1).equals("from") && isTime ? "at" : pair.group(1);
    if (keyed.put(key, value) != null) {
      throw bad("expected '" + key + "' only once");
    }
  }

  /** The parts between separators outside parentheses. */
  List<String> split(String whole, char separator) {
    List<String> parts = new ArrayList<>();
    int depth = 0;
    int begin = 0;
    for (int i = 0; i < whole.length(); i++) {
      char c = whole.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth < 0) {
        throw bad("expected a ( before each )");
      }
      if (c == separator && depth == 0) {
        parts.add(whole.substring(begin, i));
        begin = i + 1;
      }
    }
    if (depth != 0) {
      throw bad("expected a ) for each (");
    }
    parts.add(whole.substring(begin));
    return parts;
  }

  String name() {
    return name;
  }

  /** Sets the usage text for errors. */
  void usage(String newUsage) {
    usage = newUsage;
  }

  /** Reads the affected robots, the next argument by position; all robots without this call. */
  void readRobots() {
    robots = next(RobotSelector.EXPECTED, ArgumentType.ROBOTS);
  }

  /** The next argument by position. */
  <T> T next(String what, ArgumentType<T> type) {
    T value = read(what, nextText(what), type);
    canonical.add(type.writer().apply(value));
    return value;
  }

  /** The next argument by position, as text. */
  String nextText(String what) {
    if (used == placed.size()) {
      throw bad("expected " + what + ", as in " + usage);
    }
    return placed.get(used++);
  }

  /** The next argument by position; {@code usual} if there is none. */
  <T> T nextOr(String what, ArgumentType<T> type, T usual) {
    return used == placed.size()
        ? usual
        : canonical("", read(what, nextText(what), type), type, usual);
  }

  /** The argument with this key; {@code usual} if there is none. */
  <T> T keyed(String key, ArgumentType<T> type, T usual) {
    String text = keyed(key);
    return text == null ? usual : canonical(key + "=", read(key, text, type), type, usual);
  }

  private <T> T canonical(String prefix, T value, ArgumentType<T> type, T usual) {
    if (!value.equals(usual)) {
      write(prefix + type.writer().apply(value));
    }
    return value;
  }

  /** Adds an argument to the canonical form. */
  void write(String argument) {
    canonical.add(argument);
  }

  /** The text under a key, or null. */
  @Nullable String keyed(String key) {
    asked.add(key);
    return keyed.get(key);
  }

  /** Reads an argument or a part of it; an error names {@code what}. */
  <T> T read(String what, String part, ArgumentType<T> type) {
    try {
      T value = type.reader().apply(part);
      if (value instanceof RobotSelector selector) {
        named.add(selector);
      }
      return value;
    } catch (BadInput wrong) {
      throw Quantities.in(BadInput.quote(text) + ": " + what, wrong);
    }
  }

  /** The effect of the fault whose arguments were read. */
  FaultEffect effect(FaultAction action) {
    return new FaultEffect(name, canonical, robots, named, action);
  }

  /** @throws BadInput if an argument was not used */
  void end() {
    if (used < placed.size()) {
      throw bad(BadInput.quote(placed.get(used)) + " is an extra argument; expected " + usage);
    }
    for (String key : keyed.keySet()) {
      if (!asked.contains(key)) {
        throw bad("no argument is called " + BadInput.quote(key) + NearMatches.hint(key, asked));
      }
    }
  }

  BadInput bad(String what) {
    return new BadInput(BadInput.quote(text) + ": " + what);
  }
}
