package org.starl.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class PairKeyTest {

  private static byte[] derive(String purpose, String... context) {
    byte[][] parts = new byte[context.length][];
    for (int i = 0; i < parts.length; i++) {
      parts[i] = context[i].getBytes(StandardCharsets.US_ASCII);
    }
    return new PairKey(new byte[PairKey.BYTES]).derive(purpose, parts);
  }

  /** Two robots' names with their starts must not read as two others'. */
  @Test
  void otherPurposesAndContextsGiveOtherKeys() {
    assertThat(derive("seal", "ab", "c")).isEqualTo(derive("seal", "ab", "c"));
    assertThat(derive("seal", "ab", "c")).isNotEqualTo(derive("seal", "a", "bc"));
    assertThat(derive("seal", "ab", "c")).isNotEqualTo(derive("seal", "c", "ab"));
    assertThat(derive("seal", "ab")).isNotEqualTo(derive("session id", "ab"));
  }
}
