package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** {@code docs/trace-format.md} says what the code does. */
class TraceFormatDocTest {

  private static final Pattern EXAMPLE = Pattern.compile("```json\n(.*?\n)```", Pattern.DOTALL);

  private final String doc = read(Path.of("..", "docs", "trace-format.md"));

  @Test
  void theExamplesFormATraceThatIsWrittenIdentically() throws IOException {
    String examples =
        EXAMPLE.matcher(doc).results().map(m -> m.group(1)).collect(Collectors.joining());
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    try (TraceReader reader =
        new TraceReader(
            "trace-format.md",
            new ByteArrayInputStream(examples.getBytes(StandardCharsets.UTF_8)))) {
      TraceWriter writer = new TraceWriter(written, reader.header());
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        writer.record(event);
      }
      TraceEnd end = reader.end();
      assertThat(end).isNotNull();
      writer.end(end.timeNs());
      writer.close();
    }
    assertThat(written.toString(StandardCharsets.UTF_8)).isEqualTo(examples);
  }

  @Test
  void everyKindHasAnExample() {
    for (Class<?> kind : TraceEvent.class.getPermittedSubclasses()) {
      String name = kind.getSimpleName().toLowerCase(java.util.Locale.ROOT);
      assertThat(doc).contains("### `" + name + "`", "\n{\"kind\":\"" + name + "\",");
    }
    assertThat(doc).contains("{\"kind\":\"header\",\"format\":" + TraceHeader.FORMAT + ",");
  }

  @Test
  void everyKeyIsExplained() {
    Set<String> keys = new TreeSet<>();
    for (String line : EXAMPLE.matcher(doc).results().map(m -> m.group(1)).toList()) {
      Matcher key = Pattern.compile("[{,]\"([a-zA-Z]+)\":").matcher(line);
      key.results().map(m -> m.group(1)).forEach(keys::add);
    }
    // Settings of the example header, not keys of the format.
    keys.removeAll(List.of("delay", "loss"));
    assertThat(keys)
        .contains("settings", "headingRad")
        .allSatisfy(key -> assertThat(withoutExamples()).contains("`" + key + "`"));
  }

  @Test
  void theExampleErrorIsTheReadersError() {
    String text =
        """
        {"kind":"header","format":1,"starl":"","scenario":"","scenarioSeed":1,"behaviourSeed":2,\
        "settings":{},"robots":[]}
        {"kind":"left","timeNs":x,"robot":"bot0"}
        """;
    String message = TraceReaderTest.errorOf(text);
    assertThat(doc).contains("\n" + message + "\n");
  }

  private String withoutExamples() {
    return EXAMPLE.matcher(doc).replaceAll("");
  }

  private static String read(Path path) {
    try {
      return Files.readString(path);
    } catch (IOException e) {
      throw new IllegalStateException(path + " cannot be read", e);
    }
  }
}
