package org.starl.primitives.agreement;

/**
 * The outcome of a {@link SetAgreement}, as far as this robot knows.
 *
 * @param <T> the values
 */
public sealed interface Decision<T> {

  default boolean isDecided() {
    return this instanceof Decided;
  }

  /**
   * The value agreed on; the same on every robot, for ever.
   *
   * @param bytes the value as its shape writes it; the trace shows them
   */
  record Decided<T>(T value, Value bytes) implements Decision<T> {
    /** The bytes, in hexadecimal digits. */
    @Override
    public String toString() {
      return bytes.toString();
    }
  }

  /** This robot knows of no decision. */
  record NoneYet<T>() implements Decision<T> {
    @Override
    public String toString() {
      return "null";
    }
  }
}
