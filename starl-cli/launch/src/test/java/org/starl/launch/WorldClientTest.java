package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.launch.WorldClient.Word;
import org.starl.sim.check.MalformedBytes;

/** Any bytes from a connection to the world server. */
class WorldClientTest {

  private static byte[] bytes(String... words) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    for (String word : words) {
      out.writeUTF(word);
    }
    return bytes.toByteArray();
  }

  private static DataInputStream in(byte[] bytes) {
    return new DataInputStream(new ByteArrayInputStream(bytes));
  }

  private static void readAll(byte[] input) {
    DataInputStream in = in(input);
    try {
      while (true) {
        assertThat(Word.values()).contains(Word.read(in));
      }
    } catch (IOException refused) {
      assertThat(String.valueOf(refused.getMessage())).hasSizeLessThan(200).matches("[ -~]*");
    }
  }

  @Test
  void wordsAreReadUntilTheEnd() throws IOException {
    DataInputStream in = in(bytes("PLACE", "LIFT"));

    assertThat(Word.read(in)).isEqualTo(Word.PLACE);
    assertThat(Word.read(in)).isEqualTo(Word.LIFT);
    assertThatThrownBy(() -> Word.read(in)).isInstanceOf(EOFException.class);
  }

  @Test
  void anUnknownWordIsRefusedAndNotRepeated() throws IOException {
    DataInputStream in = in(bytes("rm\n\u001b[2J"));

    assertThatThrownBy(() -> Word.read(in))
        .hasMessage("expected one of [PLACE, PLACED, LIFT, LIFTED]");
  }

  @Test
  void anyBytesAreWordsOrRefused() throws IOException {
    MalformedBytes.feed(
        List.of(bytes("PLACE", "LIFT", "PLACE"), bytes("PLACED", "LIFTED"), bytes("a".repeat(70))),
        WorldClientTest::readAll);
  }
}
