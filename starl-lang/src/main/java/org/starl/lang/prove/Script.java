package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.List;

/** The text of one obligation, in the order in which it is translated. */
final class Script {

  private static final int WIDTH = 100;

  private final List<String> lines = new ArrayList<>();
  private final List<String> conditions = new ArrayList<>();

  void comment(String text) {
    lines.add("");
    text.lines().forEach(line -> lines.add("; " + line));
  }

  void line(String text) {
    lines.add(text.length() <= WIDTH ? text : broken(SExpr.read(text), 0));
  }

  void declare(String name, List<String> arguments, String result) {
    line("(declare-fun " + name + " (" + String.join(" ", arguments) + ") " + result + ")");
  }

  /** Says that {@code condition} holds. */
  void require(String condition) {
    if (!condition.equals(Smt.TRUE)) {
      line(Smt.call("assert", condition));
      conditions.add(condition);
    }
  }

  /** All that {@link #require} said. */
  List<String> conditions() {
    return conditions;
  }

  /** A long expression in several lines. */
  private static String broken(SExpr text, int indent) {
    String whole = text.toString();
    if (whole.length() + indent <= WIDTH || text.parts().size() < 2) {
      return whole;
    }
    StringBuilder all = new StringBuilder("(").append(broken(text.parts().getFirst(), indent + 1));
    for (SExpr part : text.parts().subList(1, text.parts().size())) {
      all.append('\n').append(" ".repeat(indent + 2)).append(broken(part, indent + 2));
    }
    return all.append(')').toString();
  }

  @Override
  public String toString() {
    return String.join("\n", lines) + "\n";
  }
}
