package org.starl.primitives.agreement;

/** The outcome of a {@link SetAgreement}, as far as this robot knows. */
public sealed interface Decision {

  Decision NONE_YET = new NoneYet();

  boolean isDecided();

  /** The value agreed on; the same on every robot, for ever. */
  record Decided(Value value) implements Decision {
    @Override
    public boolean isDecided() {
      return true;
    }

    @Override
    public String toString() {
      return value.toString();
    }
  }

  /** This robot knows of no decision. */
  record NoneYet() implements Decision {
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
