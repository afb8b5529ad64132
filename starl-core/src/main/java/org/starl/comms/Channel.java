package org.starl.comms;

/**
 * Where messages of one kind meet: a primitive's name, the id of its instance, and the codec. Two
 * instances of one primitive never hear each other.
 *
 * @param primitive 1 to 31 letters, digits, {@code _}, {@code -} or {@code .}
 * @param instance likewise
 */
public record Channel<T>(String primitive, String instance, Codec<T> codec) {

  public Channel {
    check(primitive);
    check(instance);
  }

  /** {@code primitive/instance}, as on the wire and in the trace. */
  public String name() {
    return primitive + "/" + instance;
  }

  /** Whether {@code name} is that of a channel: two valid parts and a slash. */
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
