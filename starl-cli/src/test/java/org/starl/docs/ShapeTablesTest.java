package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.SumShape;

/**
 * The tables of messages, facts and variables in {@code docs} are made from their shapes. A line
 * <code>&lt;!-- shapes: messages mutex --&gt;</code> says what the table below it is of.
 */
class ShapeTablesTest {

  private static final Path DOCS = Path.of("../docs");
  private static final String LINE = "|---|---|---|";
  private static final Pattern TABLE =
      Pattern.compile("(?m)^<!-- shapes: (\\w+)(?: ([\\w.]+))? -->\n(?:\\|.*\n)*");

  @ParameterizedTest
  @ValueSource(strings = {"wire-format.md", "trace-format.md"})
  void theTablesAreThoseOfTheShapes(String name) throws IOException {
    String page = Files.readString(DOCS.resolve(name));
    String right = TABLE.matcher(page).replaceAll(ShapeTablesTest::table);
    if (!page.equals(right)) {
      Files.createDirectories(Path.of("target/docs"));
      Files.writeString(Path.of("target/docs", name), right);
    }
    assertThat(page).as("the right page is starl-apps/cli/target/docs/%s", name).isEqualTo(right);
  }

  @Test
  void theMessagesOfEveryPrimitiveHaveATable() throws IOException {
    String page = Files.readString(DOCS.resolve("wire-format.md"));
    assertThat(TABLE.matcher(page).results().map(table -> messages(table.group(2)).describe()))
        .containsAll(
            PrimitiveVocabulary.ALL.messages().values().stream()
                .filter(SumShape.class::isInstance)
                .map(Shape::describe)
                .toList());
  }

  private static String table(MatchResult marker) {
    List<String> rows = new ArrayList<>(List.of(marker.group().lines().findFirst().orElseThrow()));
    switch (marker.group(1)) {
      case "messages" -> {
        row(rows, "byte", "message", "parts");
        rows.add(LINE);
        int number = 0;
        for (RecordShape<?> message : messages(marker.group(2)).records()) {
          row(rows, String.valueOf(++number), "`" + message.name() + "`", parts(message));
        }
      }
      case "facts" -> {
        row(rows, "source", "fact", "parts");
        rows.add(LINE);
        PrimitiveVocabulary.ALL
            .facts()
            .forEach((key, fact) -> row(rows, source(key), "`" + fact.name() + "`", parts(fact)));
      }
      case "variables" -> {
        row(rows, "source", "variable", "type");
        rows.add(LINE);
        PrimitiveVocabulary.ALL
            .variables()
            .forEach((key, variable) ->
                row(rows, source(key), "`" + variable.name() + "`", type(variable.shape())));
      }
      default -> throw new IllegalArgumentException(marker.group());
    }
    return String.join("\n", rows).replace("\\", "\\\\").replace("$", "\\$") + "\n";
  }

  private static void row(List<String> rows, String... cells) {
    rows.add("| " + String.join(" | ", cells) + " |");
  }

  private static String source(String key) {
    return "`" + key.substring(0, key.indexOf(' ')) + "`";
  }

  private static SumShape<?> messages(String kind) {
    return (SumShape<?>) Objects.requireNonNull(PrimitiveVocabulary.ALL.messages().get(kind), kind);
  }

  /** With the parts of each record. */
  private static String type(Shape<?> shape) {
    return shape instanceof SumShape<?> sum
        ? sum.records().stream().map(RecordShape::describe).collect(Collectors.joining(" or "))
        : shape.describe();
  }

  private static String parts(RecordShape<?> record) {
    return record.parts().isEmpty()
        ? "none"
        : record.parts().stream()
            .map(part -> "`" + part.name() + "`: " + type(part.shape()))
            .collect(Collectors.joining("; "));
  }
}
