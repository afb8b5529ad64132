package org.starl.deployment;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.MalformedBytes;

/** Any bytes from somebody who asks the world for a body. */
class ShortLinesTest {

  private static List<String> lines(InputStream in) throws IOException {
    List<String> lines = new ArrayList<>();
    try (ShortLines reader = new ShortLines(in)) {
      for (String line = reader.next(); line != null; line = reader.next()) {
        lines.add(line);
      }
    }
    return lines;
  }

  private static void read(byte[] input) {
    String text = new String(input, US_ASCII);
    try {
      for (String line : lines(new ByteArrayInputStream(input))) {
        assertThat(line).hasSizeLessThanOrEqualTo(ShortLines.MAX_LENGTH).matches("[ -~]*");
        assertThat(text).contains(line + "\n");
      }
    } catch (IOException refused) {
      assertThat(refused).hasMessageContaining("expected up to 64 letters");
    }
  }

  @Test
  void wordsAreReadAndWhatIsNotEndedIsNone() throws IOException {
    byte[] said = "bot1\nplace\n\nlif".getBytes(US_ASCII);

    assertThat(lines(new ByteArrayInputStream(said))).containsExactly("bot1", "place", "");
  }

  @Test
  void whoNeverEndsALineIsNotListenedTo() {
    int[] read = new int[1];
    InputStream endless =
        new InputStream() {
          @Override
          public int read() {
            read[0]++;
            return 'a';
          }
        };

    assertThatThrownBy(() -> lines(endless)).hasMessageContaining("expected up to 64 letters");
    assertThat(read[0]).isEqualTo(ShortLines.MAX_LENGTH + 1);
  }

  @Test
  void anyBytesAreShortLinesOrRefused() {
    List<byte[]> samples = new ArrayList<>();
    samples.add("bot1\nplace\nlift\nplace\n".getBytes(US_ASCII));
    samples.add("placed\nlifted\n".getBytes(US_ASCII));
    samples.add("a".repeat(70).getBytes(US_ASCII));

    MalformedBytes.feed(samples, ShortLinesTest::read);
  }
}
