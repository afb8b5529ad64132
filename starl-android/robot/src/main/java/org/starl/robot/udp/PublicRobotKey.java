package org.starl.robot.udp;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.interfaces.ECPublicKey;
import java.security.spec.ECFieldFp;
import java.security.spec.ECPoint;
import java.security.spec.X509EncodedKeySpec;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The public half of a {@link RobotKey}, as a deployment file lists it: the Base64 of its {@code
 * SubjectPublicKeyInfo} (RFC 5480), which begins with {@link #PREFIX}. Immutable.
 */
public final class PublicRobotKey {

  /** How every key begins: the algorithm and the curve, P-256. */
  public static final String PREFIX = "MFkwEwYHKoZIzj0CAQYIKoZIzj0DAQcDQgAE";

  /** A key's length in characters. */
  public static final int LENGTH = 124;

  private static final String ONE =
      PREFIX + "[A-Za-z0-9+/]{" + (LENGTH - PREFIX.length() - 2) + "}==";

  /** A regular expression for one or more keys; it does not check that they are points. */
  public static final String PATTERN = "^ *" + ONE + "( +" + ONE + ")* *$";

  private final ECPublicKey key;

  PublicRobotKey(ECPublicKey key) {
    this.key = key;
  }

  /** The keys in a text, separated by spaces; null if a part of it is not a key, or there is none. */
  public static @Nullable List<PublicRobotKey> parseOrNull(String text) {
    List<PublicRobotKey> keys = new ArrayList<>();
    for (String part : text.trim().split(" +", -1)) {
      ECPublicKey key = part.matches(ONE) ? read(part) : null;
      if (key == null || !isOnCurve(key)) {
        return null;
      }
      keys.add(new PublicRobotKey(key));
    }
    return keys;
  }

  private static @Nullable ECPublicKey read(String text) {
    try {
      byte[] encoded = Base64.getDecoder().decode(text);
      return (ECPublicKey)
          KeyFactory.getInstance("EC").generatePublic(new X509EncodedKeySpec(encoded));
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      return null; // not Base64, or not a point
    }
  }

  // A point off the curve would reveal the other side's key; not every platform checks it.
  private static boolean isOnCurve(ECPublicKey key) {
    ECPoint point = key.getW();
    BigInteger p = ((ECFieldFp) key.getParams().getCurve().getField()).getP();
    BigInteger x = point.getAffineX();
    BigInteger y = point.getAffineY();
    BigInteger right =
        x.pow(3)
            .add(key.getParams().getCurve().getA().multiply(x))
            .add(key.getParams().getCurve().getB());
    return x.compareTo(p) < 0
        && y.compareTo(p) < 0
        && y.pow(2).subtract(right).mod(p).signum() == 0;
  }

  ECPublicKey key() {
    return key;
  }

  /** As the deployment file lists it. */
  @Override
  public String toString() {
    return Base64.getEncoder().encodeToString(key.getEncoded());
  }
}
