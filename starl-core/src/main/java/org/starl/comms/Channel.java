package org.starl.comms;

import java.nio.charset.StandardCharsets;
import org.starl.shape.Shape;
import org.starl.trace.Instance;

/**
 * A stream of messages of one type: a primitive's name, the id of its instance, and the shape. Two
 * instances of one primitive have different channels.
 */
public final class Channel<T> {

  private final Instance instance;
  private final Shape<T> shape;

  /** The name on the wire. Robots that share a channel object share this array. */
  final byte[] wireName;

  /** A channel of the app, for messages between robots. */
  public static <T> Channel<T> of(String name, Shape<T> shape) {
    return new Channel<>(Instance.APP.primitive(), name, shape);
  }

  /**
   * @param primitive 1 to 31 letters, digits, {@code _}, {@code -} or {@code .}
   * @param instance likewise
   */
  public Channel(String primitive, String instance, Shape<T> shape) {
    check(primitive);
    check(instance);
    this.instance = Instance.of(primitive, instance);
    this.shape = shape;
    this.wireName = this.instance.name().getBytes(StandardCharsets.US_ASCII);
  }

  /** The channel's name {@code primitive/instance}, as on the wire and in the trace. */
  public String name() {
    return instance.name();
  }

  /** The instance of the primitive that it belongs to. */
  public Instance instance() {
    return instance;
  }

  /** How its messages are written. */
  public Shape<T> shape() {
    return shape;
  }

  @Override
  public String toString() {
    return name();
  }

  /** Whether {@code name} is a valid channel name: two valid parts and a slash. */
  static boolean isName(String name) {
    int slash = name.indexOf('/');
    return slash >= 0 && isPart(name.substring(0, slash)) && isPart(name.substring(slash + 1));
  }

  private static void check(String part) {
    if (!isPart(part)) {
      throw new IllegalArgumentException(
          "channel name '" + part + "': expected 1 to 31 of A-Z a-z 0-9 _ - .");
    }
  }

  private static boolean isPart(String part) {
    boolean valid = !part.isEmpty() && part.length() <= 31;
    for (int i = 0; i < part.length() && valid; i++) {
      char c = part.charAt(i);
      valid =
          (c >= 'a' && c <= 'z')
              || (c >= 'A' && c <= 'Z')
              || (c >= '0' && c <= '9')
              || c == '_'
              || c == '-'
              || c == '.';
    }
    return valid;
  }
}
