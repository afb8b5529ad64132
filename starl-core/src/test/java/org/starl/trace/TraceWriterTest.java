package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

class TraceWriterTest {

  private static final TraceHeader HEADER = new TraceHeader("0", "s", 1, 2, Map.of(), List.of());
  private static final TraceEvent EVENT =
      new TraceEvent.Moved(1_234_567_890L, new RobotId("bot0"), new Pose(-1.5, 1e6, 0.5), 0.25, -1);

  @Test
  void linesDoNotDependOnTheLocale() {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
      assertThat(TraceCodec.line(EVENT))
          .isEqualTo(
              "{\"kind\":\"moved\",\"timeNs\":1234567890,\"robot\":\"bot0\",\"xMm\":-1.500,"
                  + "\"yMm\":1000000.000,\"headingRad\":0.500000,\"linearMmPerS\":0.250,"
                  + "\"angularRadPerS\":-1.000000}");
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void aFailureToWriteIsKeptAndThrownByClose() throws IOException {
    TraceWriter writer = new TraceWriter(new FullDisk(), HEADER);
    assertThat(writer.failure()).isNull();
    for (int i = 0; i < 1_000; i++) {
      writer.record(EVENT);
    }
    assertThat(writer.failure()).hasMessage("disk full");
    assertThatThrownBy(writer::close).isSameAs(writer.failure());
  }

  @Test
  void aFailureOfTheLastBytesIsThrownByCloseToo() {
    TraceWriter writer = new TraceWriter(new FullDisk(), HEADER);
    writer.record(EVENT);
    assertThatThrownBy(writer::close).isInstanceOf(IOException.class).hasMessage("disk full");
  }

  @Test
  void everythingIsWrittenByClose() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TraceWriter writer = new TraceWriter(out, HEADER)) {
      for (int i = 0; i < 1_000; i++) {
        writer.record(EVENT);
      }
      assertThat(writer.events()).isEqualTo(1_000);
      writer.end(5);
    }
    String text = out.toString(StandardCharsets.UTF_8);
    assertThat(text).endsWith("\n{\"kind\":\"end\",\"timeNs\":5,\"events\":1000}\n");
    assertThat(text.lines()).hasSize(1_002);
  }

  @Test
  void nothingIsRecordedAfterTheEnd() throws IOException {
    try (TraceWriter writer = new TraceWriter(new ByteArrayOutputStream(), HEADER)) {
      writer.end(5);
      assertThatThrownBy(() -> writer.record(EVENT)).isInstanceOf(IllegalStateException.class);
      assertThatThrownBy(() -> writer.end(6)).isInstanceOf(IllegalStateException.class);
    }
  }

  private static final class FullDisk extends OutputStream {
    @Override
    public void write(int b) throws IOException {
      throw new IOException("disk full");
    }
  }
}
