package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Point;
import org.starl.shape.Json;
import org.starl.shape.JsonFormatException;
import org.starl.shape.Shapes;

class TraceReaderTest {

  static final String HEADER =
      "{\"kind\":\"header\",\"format\":3,\"starl\":\"0\",\"scenario\":\"s\",\"scenarioSeed\":1,"
          + "\"behaviourSeed\":2,\"settings\":{},\"robots\":[\"bot0\"]}\n";
  private static final String LEFT = "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"bot0\"}\n";
  private static final String ACTION =
      "{\"kind\":\"action\",\"timeNs\":5,\"robot\":\"bot0\",\"source\":\"lamp/x\",\"fact\":{";
  private static final Vocabulary VOCABULARY =
      Vocabulary.NONE.facts(
          "lamp",
          Shapes.of(
              Point.class,
              Shapes.part("xMm", Shapes.REAL, Point::xMm),
              Shapes.part("yMm", Shapes.REAL, Point::yMm),
              Point::new));
  private static final String START = "{\"kind\":\"joined\",\"timeNs\":0,\"robot\":\"bot0\",";

  @Test
  void aTraceCutBetweenLinesHasNoEnd() throws IOException {
    try (TraceReader reader = reader((HEADER + LEFT).getBytes(StandardCharsets.UTF_8))) {
      assertThat(reader.next()).isNotNull();
      assertThat(reader.lineNumber()).isEqualTo(2);
      assertThat(reader.next()).isNull();
      assertThat(reader.end()).isNull();
    }
  }

  /** As Git and editors on Windows make of it. */
  @Test
  void aByteOrderMarkAndLineEndsOfWindowsAreRead() throws IOException {
    byte[] bytes =
        ("\uFEFF" + HEADER + LEFT).replace("\n", "\r\n").getBytes(StandardCharsets.UTF_8);
    try (TraceReader reader = reader(bytes)) {
      assertThat(reader.next()).isNotNull();
      assertThat(reader.next()).isNull();
    }
  }

  @Test
  void anErrorNamesFileLineColumnAndWhatWasExpected() {
    assertThat(errorOf(HEADER + LEFT + "{\"kind\":\"left\",\"timeNs\":5, \"robot\":\"bot0\"}\n"))
        .isEqualTo("run.trace:3: column 26: expected ,\"robot\":, found , \"robot\":\"bot0\"}");
  }

  @Test
  void aFileThatIsNotATraceIsRefusedAtOnce() {
    assertThat(errorOf("")).startsWith("run.trace:1: ").contains("the header of a StarL trace");
    assertThat(errorOf("time,x,y\n")).contains("the header of a StarL trace");
    assertThat(errorOf(HEADER.replace("\"format\":3,", "\"format\":1,")))
        .contains("expected format 3, found 1,");
    assertThat(errorOf(HEADER.replace("{}", "{\"a\":\"1\",\"a\":\"2\"}")))
        .contains("each key once");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      quoteCharacter = '\0',
      value = {
        "{\"kind\":\"jumped\",\"timeNs\":5,\"robot\":\"bot0\"}|a known kind, found jumped",
        "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"0bot\"}|a robot's name, found \"0bot\"}",
        "{\"kind\":\"left\",\"timeNs\":9223372036854775808,\"robot\":\"a\"}|at most 64 bits",
        "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"bot0\"} |the end of the line",
        "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"bot0|a string that ends",
        "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"\\u00g0\"}|four hexadecimal digits",
        "{\"kind\":\"left\",\"timeNs\":5,\"robot\":\"\\x\"}|an escape of JSON",
        "{\"kind\":\"end\",\"timeNs\":5,\"events\":1}|0}, the number of events above",
        "{\"kind\":\"left\"|expected ,\"timeNs\":, found the end of the line",
      })
  void anInvalidLineIsAnError(String line, String message) {
    assertThat(errorOf(HEADER + line + "\n")).startsWith("run.trace:2: ").contains(message);
  }

  @Test
  void aNumberNeedsItsExactDecimals() {
    assertThat(errorOf(HEADER + START + "\"xMm\":1,\"yMm\":0.000}\n"))
        .contains("a number with 3 decimals, found 1,");
    assertThat(errorOf(HEADER + START + "\"xMm\":1.0000,\"yMm\":0.000}\n"))
        .contains("a number with 3 decimals");
    assertThat(errorOf(HEADER + START + "\"xMm\":NaN,\"yMm\":0.000}\n")).contains("a digit");
    assertThat(errorOf(HEADER + START + "\"xMm\":" + "9".repeat(400) + ".000,\"yMm\":0.000}\n"))
        .contains("at most 308 digits");
  }

  @Test
  void aKnownFactMustHaveItsShape() {
    assertThat(errorOf(HEADER + ACTION + "\"Point\":{\"xMm\":1.0,\"zMm\":2.0}}}\n"))
        .isEqualTo("run.trace:2: column 88: expected ,\"yMm\":, found ,\"zMm\":2.0}}}");
    assertThat(errorOf(HEADER + ACTION + "\"Point\":{\"xMm\":one,\"yMm\":2.0}}}\n"))
        .startsWith("run.trace:2: column 85: expected a number, found one,");
  }

  @Test
  void anUnknownFactIsReadAsJson() throws IOException {
    String line = ACTION + "\"glow\":{\"lux\":[1,\"a\"]}}}\n";
    try (TraceReader reader = reader((HEADER + line).getBytes(StandardCharsets.UTF_8))) {
      TraceEvent.Action action = (TraceEvent.Action) reader.next();
      assertThat(action).isNotNull();
      assertThat(action.name()).isEqualTo("glow");
      assertThat(action.fact()).isEqualTo(new Json("{\"lux\":[1,\"a\"]}"));
      assertThat(TraceCodec.line(action) + "\n").isEqualTo(line);
    }
  }

  @Test
  void nothingFollowsTheEnd() {
    String end = "{\"kind\":\"end\",\"timeNs\":5,\"events\":1}\n";
    assertThat(errorOf(HEADER + LEFT + end + LEFT))
        .startsWith("run.trace:4: ")
        .contains("nothing after the line of kind end");
  }

  @Test
  void aTraceCutInsideALineIsAnError() {
    assertThat(errorOf(HEADER + LEFT + "{\"kind\":\"le"))
        .isEqualTo("run.trace:3: expected a whole line: the trace was cut off inside it");
  }

  @Test
  void invalidUtf8IsAnError() throws IOException {
    byte[] bytes = (HEADER + LEFT).getBytes(StandardCharsets.UTF_8);
    bytes[bytes.length - 4] = (byte) 0xFF;
    assertThat(errorOf(bytes)).isEqualTo("run.trace:2: expected text in UTF-8");
  }

  @Test
  void anErrorMessageIsAlwaysOneLine() {
    assertThat(errorOf("\u001b[2J\r\n")).doesNotContain("\u001b").doesNotContain("\r");
  }

  static String errorOf(String text) {
    return errorOf(text.getBytes(StandardCharsets.UTF_8));
  }

  private static String errorOf(byte[] bytes) {
    JsonFormatException error =
        catchThrowableOfType(JsonFormatException.class, () -> readAll(bytes));
    assertThat(error).as("nothing was wrong").isNotNull();
    return String.valueOf(error.getMessage());
  }

  private static void readAll(byte[] bytes) throws IOException {
    try (TraceReader reader = reader(bytes)) {
      TraceEvent event = reader.next();
      while (event != null) {
        event = reader.next();
      }
    }
  }

  static TraceReader reader(byte[] bytes) throws IOException {
    return new TraceReader("run.trace", new ByteArrayInputStream(bytes), VOCABULARY);
  }
}
