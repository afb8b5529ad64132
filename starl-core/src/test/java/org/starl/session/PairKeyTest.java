package org.starl.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
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

  /** As Python computes it: {@code hmac.new(bytes(range(32)), info + b'\x01', sha256)}. */
  @Test
  void aKeyIsTheFirstBlockOfHkdf() {
    byte[] secret = new byte[PairKey.BYTES];
    for (int i = 0; i < secret.length; i++) {
      secret[i] = (byte) i;
    }
    byte[] key = new PairKey(secret).derive("seal", new byte[] {'a', 'b'}, new byte[] {'c'});
    assertThat(HexFormat.of().formatHex(key))
        .isEqualTo("d7207eb37384724b689804583a3cfd79d9c1733a33855e8ad11900960743975a");
  }

  @Test
  void aSecretHas32BytesAndIsItsOwn() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new PairKey(new byte[31]))
        .withMessage("a key of 31 bytes: expected 32");
    byte[] secret = new byte[PairKey.BYTES];
    PairKey key = new PairKey(secret);
    secret[0] = 1;
    assertThat(key).isEqualTo(new PairKey(new byte[PairKey.BYTES]));
    assertThat(key).isNotEqualTo(new PairKey(secret));
    assertThat(key.id()).isNotEqualTo(new PairKey(secret).id());
    assertThat(key).as("it is never printed").hasToString("a pair's key");
  }
}
