package org.starl.primitives.agreement;

/** The outcome of a {@link SetAgreement}, as far as this robot knows. */
public sealed interface Decision {

  Decision NONE_YET = new NoneYet();

  default boolean isDecided() {
    return this instanceof Decided;
  }

  /** The value agreed on; the same on every robot, for ever. */
  record Decided(Value value) implements Decision {
    @Override
    public String toString() {
      return value.toString();
    }
  }

  /** This robot knows of no decision. */
  record NoneYet() implements Decision {
    @Override
    public String toString() {
      return "null";
    }
  }
}
