package org.starl.cli;

import java.util.ArrayList;
import java.util.List;

/** A text table of names and values: names to the left, values to the right. */
final class Table {

  private record Row(String name, String value) {}

  private final List<Row> rows = new ArrayList<>();

  void row(String name, String value) {
    rows.add(new Row(name, value));
  }

  List<String> lines() {
    int nameWidth = rows.stream().mapToInt(row -> row.name().length()).max().orElse(0);
    int valueWidth = rows.stream().mapToInt(row -> row.value().length()).max().orElse(0);
    return rows.stream()
        .map(row -> {
          int width = nameWidth - row.name().length() + 2 + valueWidth;
          return (row.name() + " ".repeat(width - row.value().length()) + row.value())
              .stripTrailing();
        })
        .toList();
  }
}
