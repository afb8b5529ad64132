package org.starl.sim.explore;

import java.util.Arrays;
import java.util.Locale;
import org.starl.input.BadInput;

/** How the next schedule is chosen; see the package. */
public enum Strategy {
  RANDOM,
  PCT,
  EXHAUSTIVE;

  /** @throws BadInput if no strategy has this name */
  public static Strategy parse(String text) {
    for (Strategy strategy : values()) {
      if (strategy.toString().equals(text.strip())) {
        return strategy;
      }
    }
    throw new BadInput(BadInput.quote(text) + ": expected one of " + Arrays.toString(values()));
  }

  /** The name as in {@code --strategy pct}. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
