package org.starl.primitives.geocast;

import java.util.Locale;

/** Why an arrived copy is not delivered. */
public enum Dismissal {
  /** This robot may be outside the area. */
  OUTSIDE,
  /** The interval may be over. */
  LATE,
  /** The copy is from the future: the clocks differ by more than the allowed skew. */
  EARLY;

  /** For people: {@code outside}. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
