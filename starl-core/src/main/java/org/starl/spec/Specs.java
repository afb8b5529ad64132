package org.starl.spec;

import java.util.Locale;

/** The specifications that a run checks. */
public enum Specs {

  /** None. */
  OFF,

  /** All but the {@link Monitor#progressLemmas}. */
  SAFETY,

  /** All. */
  ALL;

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
