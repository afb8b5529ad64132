package org.starl.primitives.geocast;

import org.starl.geometry.Region;

/** The messages of geocasts. */
sealed interface GeocastMessage<T> {

  GeocastId id();

  /**
   * A copy of the message with its tags.
   *
   * @param startNs t0, on the origin's clock
   * @param deadlineNs t0 + d, likewise; above {@code startNs}
   */
  record Copy<T>(GeocastId id, Region area, long startNs, long deadlineNs, T message)
      implements GeocastMessage<T> {

    public Copy {
      if (startNs < 0 || deadlineNs <= startNs) {
        throw new IllegalArgumentException(
            "geocast from " + startNs + " to " + deadlineNs + " ns: expected an interval");
      }
    }
  }

  /** The sender has delivered the message. */
  record Ack<T>(GeocastId id) implements GeocastMessage<T> {}
}
