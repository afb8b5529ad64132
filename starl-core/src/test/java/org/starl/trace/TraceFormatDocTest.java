package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.starl.comms.Codec;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.shape.Geometry;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireReader;

/** {@code docs/trace-format.md} says what the code does. */
class TraceFormatDocTest {

  private static final Pattern EXAMPLE = Pattern.compile("```json\n(.*?\n)```", Pattern.DOTALL);

  private final String doc = read(Path.of("..", "docs", "trace-format.md"));

  // The other examples are of a run: ShownOutputTest compares them.
  @Test
  void theNoteAndTheInterventionAreWrittenAsTheyAreRead() throws IOException {
    String lines =
        examples()
            .lines()
            .filter(line -> line.contains("{\"note\":") || line.contains("\"intervention\""))
            .map(line -> line + "\n")
            .collect(Collectors.joining());
    assertThat(lines.lines()).hasSize(2);
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    String text = TraceReaderTest.HEADER + lines;
    try (TraceReader reader = TraceReaderTest.reader(text.getBytes(StandardCharsets.UTF_8))) {
      TraceWriter writer = new TraceWriter(written, reader.header());
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        writer.record(event);
      }
      writer.close();
    }
    assertThat(written.toString(StandardCharsets.UTF_8)).isEqualTo(text);
  }

  private String examples() {
    return EXAMPLE.matcher(doc).results().map(m -> m.group(1)).collect(Collectors.joining());
  }

  private record Ok(int num) {
    static final RecordShape<Ok> SHAPE =
        Shapes.of(Ok.class, Shapes.part("num", Shapes.INT, Ok::num), Ok::new);
  }

  private record From(ProcessId from, int num) {
    static final RecordShape<From> SHAPE =
        Shapes.of(
            From.class,
            Shapes.part("from", Shapes.PROCESS, From::from),
            Shapes.part("num", Shapes.INT, From::num),
            From::new);
  }

  @Test
  void theExamplesOfShapesAreWhatTheyWrite() {
    RobotId bot0 = new RobotId("bot0");
    ProcessId first = ProcessId.first(bot0, 1);
    Shape<SortedMap<ProcessId, Long>> map = Shapes.map(Shapes.PROCESS, Shapes.LONG, 9);
    List<String> written =
        List.of(
            From.SHAPE.json(new From(ProcessId.first(new RobotId("bot1"), 3), 7)),
            Shapes.oneOf(Ok.class, Ok.SHAPE).json(new Ok(7)),
            Shapes.constant(MotionFlag.class).json(MotionFlag.IDLE),
            Shapes.list(Shapes.INT, 9).json(List.of(1, 2)),
            Shapes.set(Shapes.TEXT, 9).json(new TreeSet<>(List.of("C", "A"))),
            map.json(new TreeMap<>(Map.of(first, 1L))),
            Shapes.optional(Shapes.INT).json(Optional.empty()),
            Shapes.BOOL.json(true),
            Shapes.LONG.json(-12L),
            Shapes.REAL.json(2250.0),
            Shapes.REAL.json(Double.POSITIVE_INFINITY),
            Shapes.TEXT.json("corridor"),
            Shapes.ROBOT.json(bot0),
            Shapes.PROCESS.json(ProcessId.first(bot0, 2)),
            Shapes.PARTICIPANTS.json(Participants.of(List.of(bot0, new RobotId("bot1")))),
            Geometry.POINT.json(new Point(1.5, 0)),
            Geometry.REGION.json(new Circle(new Point(180, 2932.5), 1980)),
            Codec.<String>of((text, out) -> out.text(text), WireReader::text).json("hi"));
    assertThat(written).allSatisfy(json -> assertThat(doc).contains("| `" + json + "` |"));
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
    keys.removeAll(List.of("messageDelay", "messageLoss"));
    assertThat(keys)
        .contains("settings", "headingRad")
        .allSatisfy(key -> assertThat(withoutExamples()).contains("`" + key + "`"));
  }

  @Test
  void theExampleErrorIsTheReadersError() {
    String text =
        """
        {"kind":"header","format":3,"starl":"","scenario":"","scenarioSeed":1,"behaviourSeed":2,\
        "settings":{},"robots":[]}
        {"kind":"left","timeNs":x,"robot":"bot0"}
        """;
    String message = TraceReaderTest.errorOf(text);
    assertThat(doc).contains("\n" + message + "\n");
  }

  @Test
  void aTraceOfFormat1IsRefusedInTheLineThatThePageShows() {
    String text = "{\"kind\":\"header\",\"format\":1,\"starl\":\"0.1.0\",\"scenario\":\"hello\"}\n";
    assertThat(doc).contains("\n" + TraceReaderTest.errorOf(text) + "\n");
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
