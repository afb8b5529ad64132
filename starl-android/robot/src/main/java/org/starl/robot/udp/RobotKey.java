package org.starl.robot.udp;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.interfaces.ECPrivateKey;
import java.security.interfaces.ECPublicKey;
import java.security.spec.ECGenParameterSpec;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;
import java.util.List;
import javax.crypto.KeyAgreement;
import org.starl.session.PairKey;

/**
 * One robot's own secret: a key on the curve P-256, whose public half the deployment file lists. Two
 * robots compute the key that only they share from their own secret and the other's public key (ECDH,
 * NIST SP 800-56A). So a robot that is stolen can speak in its own name only. It is never printed and
 * cannot be read back. Immutable.
 *
 * <p>Its file is PEM (RFC 7468, PKCS #8), which {@code openssl pkey} reads and {@code openssl genpkey
 * -algorithm EC -pkeyopt ec_paramgen_curve:P-256} makes.
 */
public final class RobotKey {

  private static final String BEGIN = "-----BEGIN PRIVATE KEY-----";
  private static final String END = "-----END PRIVATE KEY-----";
  private static final int MAX_BYTES = 1024;
  // Of P-256 (FIPS 186-4, D.1.2.3): a secret is below it.
  private static final BigInteger ORDER =
      new BigInteger("ffffffff00000000ffffffffffffffffbce6faada7179e84f3b9cac2fc632551", 16);
  private static final String EXPECTED =
      "expected a robot's key, as 'starl keygen --robot NAME' makes it";

  private final PrivateKey secret;

  private RobotKey(PrivateKey secret) {
    this.secret = secret;
  }

  /**
   * Reads a key.
   *
   * @throws IOException if the file is missing, not a key, or readable by others; the message is one
   *     line with the file and what was expected
   */
  public static RobotKey read(Path file) throws IOException {
    String text =
        new String(KeyFile.readSecret(file, MAX_BYTES, EXPECTED), StandardCharsets.US_ASCII).trim();
    if (!text.startsWith(BEGIN) || !text.endsWith(END)) {
      throw new IOException(file + ": is not a key; " + EXPECTED);
    }
    try {
      byte[] encoded =
          Base64.getMimeDecoder()
              .decode(text.substring(BEGIN.length(), text.length() - END.length()));
      PrivateKey key =
          KeyFactory.getInstance("EC").generatePrivate(new PKCS8EncodedKeySpec(encoded));
      if (isOnP256(key)) {
        return new RobotKey(key);
      }
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      throw new IOException(file + ": is not a key; " + EXPECTED, e);
    }
    throw new IOException(file + ": is not a key on the curve P-256; " + EXPECTED);
  }

  private static boolean isOnP256(PrivateKey key) {
    return key instanceof ECPrivateKey secret
        && secret.getParams().getOrder().equals(ORDER)
        && secret.getS().signum() > 0
        && secret.getS().compareTo(ORDER) < 0;
  }

  /**
   * Writes a new key into a new file.
   *
   * @return its public half
   * @throws IOException if the file exists or cannot be created; the message is one line for people
   */
  public static PublicRobotKey generate(Path file) throws IOException {
    KeyPair pair = newPair();
    String body =
        Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(pair.getPrivate().getEncoded());
    String text = BEGIN + "\n" + body + "\n" + END + "\n";
    KeyFile.writeSecret(file, text.getBytes(StandardCharsets.US_ASCII));
    return new PublicRobotKey((ECPublicKey) pair.getPublic());
  }

  private static KeyPair newPair() {
    try {
      KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
      generator.initialize(new ECGenParameterSpec("secp256r1"));
      return generator.generateKeyPair();
    } catch (GeneralSecurityException e) {
      // Java since 7 and Android since 4.0 have this curve.
      throw new IllegalStateException("P-256", e);
    }
  }

  /** The key that this robot shares with the robot of that public key. */
  PairKey pairKey(PublicRobotKey other) {
    return pairKey(secret, other);
  }

  /** Whether one of these is this key's public half. */
  public boolean isAmong(List<PublicRobotKey> published) {
    // Both halves of a key agree with any third key on the same secret.
    KeyPair third = newPair();
    PairKey ours = pairKey(new PublicRobotKey((ECPublicKey) third.getPublic()));
    return published.stream().anyMatch(each -> pairKey(third.getPrivate(), each).equals(ours));
  }

  private static PairKey pairKey(PrivateKey secret, PublicRobotKey other) {
    try {
      KeyAgreement agreement = KeyAgreement.getInstance("ECDH");
      agreement.init(secret);
      agreement.doPhase(other.key(), true);
      byte[] agreed = agreement.generateSecret();
      return new PairKey(new PairKey(agreed).newMac("ecdh").doFinal());
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("ECDH on P-256", e);
    }
  }

  @Override
  public String toString() {
    return "a robot's key";
  }
}
