package org.starl.primitives.agreement;

/**
 * The outcome of a {@link SetAgreement}, as far as this robot knows.
 *
 * @param <T> the values
 */
public sealed interface Decision<T> {

  boolean isDecided();

  /**
   * The value agreed on; the same on every robot, for ever.
   *
   * @param bytes the value as its shape writes it; the trace shows them
   */
  record Decided<T>(T value, Value bytes) implements Decision<T> {
    @Override
    public boolean isDecided() {
      return true;
    }

    /** The bytes, in hexadecimal digits. */
    @Override
    public String toString() {
      return bytes.toString();
    }
  }

  /** This robot knows of no decision. */
  record NoneYet<T>() implements Decision<T> {
    @Override
    public boolean isDecided() {
      return false;
    }

    @Override
    public String toString() {
      return "null";
    }
  }
}
