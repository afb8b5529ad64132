package org.starl.lang.java;

import java.util.List;

/** The text of one file, by lines. */
final class JavaText {

  private static final int WIDTH = 100;

  private final StringBuilder text = new StringBuilder();

  JavaText line(int indent, String line) {
    text.append(line.isEmpty() ? "" : " ".repeat(indent)).append(line).append('\n');
    return this;
  }

  JavaText blank() {
    return line(0, "");
  }

  /** Something laid out in lines. */
  JavaText add(int indent, Layout layout) {
    text.append(layout.text(indent));
    return this;
  }

  /** {@code return value;}. */
  JavaText returned(int indent, Code value) {
    return statement(indent, "return ", value);
  }

  /** A statement: what it begins with, and the rest. */
  JavaText statement(int indent, String head, Code rest) {
    Layout layout = new Layout().token(head);
    rest.write(layout);
    return add(indent, layout.token(";"));
  }

  /** {@code case label -> value;}. */
  JavaText of(int indent, String label, Code value) {
    Layout layout = new Layout().token("case " + label + " ->").open(4).brk(" ");
    value.write(layout);
    return add(indent, layout.token(";").close());
  }

  /** A head with parameters: {@code public States trans(A a, B b)} and its brace. */
  JavaText head(int indent, String head, List<String> parameters, List<String> after) {
    Layout layout = new Layout().token(head);
    layout.open(4).open(0).token("(");
    if (!parameters.isEmpty()) {
      layout.brk("").open(0);
      for (int i = 0; i < parameters.size(); i++) {
        if (i > 0) {
          layout.token(",").brk(" ");
        }
        layout.token(parameters.get(i));
      }
      layout.close();
    }
    layout.token(")").close();
    for (int i = 0; i < after.size() - 1; i++) {
      layout.brk(" ").token(after.get(i));
    }
    layout.token(after.getLast());
    return add(indent, layout.close());
  }

  /** A comment; nothing if it is empty. Paragraphs are parted by empty lines. */
  JavaText doc(int indent, List<String> lines, List<String> tags) {
    if (lines.stream().allMatch(String::isBlank) && tags.isEmpty()) {
      return this;
    }
    String one = "/** " + escaped(String.join(" ", lines).strip()) + " */";
    if (tags.isEmpty() && !lines.contains("") && indent + one.length() <= WIDTH) {
      return line(indent, one);
    }
    line(indent, "/**");
    StringBuilder paragraph = new StringBuilder();
    for (String line : lines) {
      if (line.isBlank() && !paragraph.isEmpty()) {
        fill(indent, paragraph.toString());
        line(indent, " *");
        paragraph.setLength(0);
        paragraph.append("<p>");
      } else {
        boolean isFirst = paragraph.isEmpty() || paragraph.toString().equals("<p>");
        paragraph.append(isFirst ? "" : " ").append(escaped(line.strip().replaceAll(" +", " ")));
      }
    }
    fill(indent, paragraph.toString());
    if (!tags.isEmpty()) {
      line(indent, " *");
    }
    tags.forEach(tag -> fill(indent, tag));
    return line(indent, " */");
  }

  private void fill(int indent, String paragraph) {
    String continued = paragraph.startsWith("@") ? " *     " : " * ";
    StringBuilder line = new StringBuilder(" *");
    for (String word : paragraph.split(" ", -1)) {
      if (indent + line.length() + 1 + word.length() > WIDTH) {
        line(indent, line.toString());
        line =
            new StringBuilder(continued.stripTrailing())
                .append(continued.length() > 3 ? "    " : "");
      }
      line.append(' ').append(word);
    }
    line(indent, line.toString());
  }

  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("@", "{@literal @}")
        .replace("*/", "*&#47;");
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
