package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class TraceRoundTripTest {

  @Provide
  Arbitrary<List<TraceEvent>> runs() {
    return TraceArbitraries.events().list().ofMaxSize(12);
  }

  @Provide
  Arbitrary<TraceHeader> headers() {
    return TraceArbitraries.headers();
  }

  @Property
  void writtenEventsAreReadBackRounded(
      @ForAll("headers") TraceHeader header, @ForAll("runs") List<TraceEvent> events)
      throws IOException {
    byte[] bytes = write(header, events);
    Vocabulary vocabulary = Vocabulary.NONE;
    for (TraceEvent event : events) {
      vocabulary = vocabulary.with(event);
    }
    try (TraceReader reader =
        new TraceReader("run.trace", new ByteArrayInputStream(bytes), vocabulary)) {
      assertThat(reader.header()).isEqualTo(header);
      assertThat(new ArrayList<>(reader.header().settings().keySet()))
          .isEqualTo(new ArrayList<>(header.settings().keySet()));
      for (TraceEvent event : events) {
        assertThat(reader.next()).isEqualTo(TraceCodec.rounded(event));
      }
      assertThat(reader.next()).isNull();
      assertThat(reader.end()).isEqualTo(new TraceEnd(7, events.size(), header.robots()));
    }
  }

  @Property
  void readingAndWritingGivesTheSameBytesWithoutAnyShape(@ForAll("runs") List<TraceEvent> events)
      throws IOException {
    TraceHeader header = new TraceHeader("0", "x", 1, 2, java.util.Map.of(), List.of());
    byte[] first = write(header, events);
    List<TraceEvent> again = new ArrayList<>();
    try (TraceReader reader =
        new TraceReader("run.trace", new ByteArrayInputStream(first), Vocabulary.NONE)) {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        again.add(event);
      }
    }
    assertThat(write(header, again)).isEqualTo(first);
  }

  @Property
  void anEventIsOneLineOfTextThatUtf8CanHold(@ForAll("runs") List<TraceEvent> events) {
    for (TraceEvent event : events) {
      assertThat(TraceCodec.line(event).codePoints())
          .noneMatch(c -> c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029)
          .noneMatch(c -> c >= 0xD800 && c < 0xE000);
    }
  }

  private static byte[] write(TraceHeader header, List<TraceEvent> events) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TraceWriter writer = new TraceWriter(out, header)) {
      events.forEach(writer::record);
      writer.end(7, header.robots());
    }
    return out.toByteArray();
  }
}
