package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.platform.DeploymentKey;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a key's file: 64 digits are a key, and of anything else no message shows a part. */
public class KeyFileFuzzTest {

  private static final Path FILE = Path.of("a.key");
  private static final String NO_KEY =
      "a.key: is not a key; expected a key, as 'starl keygen' makes it: one line of 64 hexadecimal"
          + " digits";
  private static final String ZEROS = NO_KEY.replace("not a key;", "a key of zeros;");

  public static void fuzzerTestOneInput(byte[] input) {
    String text = new String(input, StandardCharsets.ISO_8859_1);
    boolean isZero = text.matches("0{64}[\r\n]{0,2}");
    boolean isKey = !isZero && text.matches("[0-9a-fA-F]{64}[\r\n]{0,2}");
    try {
      DeploymentKey key = KeyFile.parse(FILE, input);
      byte[] secret = HexFormat.of().parseHex(text.strip());
      require(isKey && key.equals(new DeploymentKey(secret)), "another key");
      require(!key.toString().contains(text.strip()), "told");
    } catch (IOException e) {
      require(
          !isKey && (isZero ? ZEROS : NO_KEY).equals(e.getMessage()),
          String.valueOf(e.getMessage()));
    }
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void onlyAValidKeyIsAccepted() {
    String digits = "0123456789abcdefABCDEF0000000000ffffffffffffffff0123456789abcdef";
    assertThat(digits).hasSize(64);

    MalformedBytes.feed(
        List.of(
            digits.getBytes(StandardCharsets.US_ASCII),
            "0".repeat(64).getBytes(StandardCharsets.US_ASCII),
            (digits + "\n").getBytes(StandardCharsets.US_ASCII),
            (digits + "\r\n").getBytes(StandardCharsets.US_ASCII)),
        KeyFileFuzzTest::fuzzerTestOneInput);
  }
}
