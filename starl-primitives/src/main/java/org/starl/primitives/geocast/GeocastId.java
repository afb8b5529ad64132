package org.starl.primitives.geocast;

import org.starl.id.ProcessId;

/**
 * The globally unique id of a geocast.
 *
 * @param origin the incarnation that started it
 * @param number counts the origin's geocasts, from 1
 */
public record GeocastId(ProcessId origin, long number) {

  public GeocastId {
    if (number <= 0) {
      throw new IllegalArgumentException("geocast number " + number + ": expected above 0");
    }
  }

  /** The text in the trace, as in {@code bot3#4294967297/7}. */
  @Override
  public String toString() {
    return origin + "/" + number;
  }
}
