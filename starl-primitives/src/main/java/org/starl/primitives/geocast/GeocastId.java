package org.starl.primitives.geocast;

import org.starl.id.ProcessId;

/**
 * One geocast, for ever and everywhere.
 *
 * @param origin the incarnation that started it
 * @param number counts this origin's geocasts, from 1
 */
public record GeocastId(ProcessId origin, long number) {

  public GeocastId {
    if (number <= 0) {
      throw new IllegalArgumentException("geocast number " + number + ": expected above 0");
    }
  }

  /** {@code bot3#4294967297/7}, as in the trace. */
  @Override
  public String toString() {
    return origin + "/" + number;
  }
}
