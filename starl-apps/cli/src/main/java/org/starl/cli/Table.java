package org.starl.cli;

import java.util.ArrayList;
import java.util.List;

/** Names and values in two columns. */
final class Table {

  private final List<String> names = new ArrayList<>();
  private final List<String> values = new ArrayList<>();

  void row(String name, String value) {
    names.add(name);
    values.add(value);
  }

  List<String> lines() {
    int nameWidth = 0;
    int valueWidth = 0;
    for (int i = 0; i < names.size(); i++) {
      nameWidth = Math.max(nameWidth, names.get(i).length());
      valueWidth = Math.max(valueWidth, values.get(i).length());
    }
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      String value = values.get(i);
      int gap = nameWidth - name.length() + 2 + valueWidth - value.length();
      lines.add((name + " ".repeat(gap) + value).stripTrailing());
    }
    return lines;
  }
}
