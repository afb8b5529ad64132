package org.starl.primitives.geocast;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.part;

import org.starl.geometry.Region;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The messages of geocasts and broadcasts.
 *
 * @param <T> the app's messages in them
 */
public sealed interface GeocastMessage<T> {

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

  /**
   * The shape of the messages of an instance, as in {@code docs/wire-format.md}. A trace's reader
   * that knows the app's messages says so: {@code vocabulary.messages(Instance.of("broadcast",
   * "news"), GeocastMessage.shape(NEWS))}.
   *
   * @param message of the app's messages
   */
  static <T> Shape<GeocastMessage<T>> shape(Shape<T> message) {
    return Shapes.oneOf(
        GeocastMessage.<GeocastMessage<T>>type(GeocastMessage.class),
        Shapes.of(
            GeocastMessage.<Copy<T>>type(Copy.class),
            part("id", GeocastId.SHAPE, Copy::id),
            part("area", RegionBytes.SHAPE, Copy::area),
            part("startNs", LONG, Copy::startNs),
            part("deadlineNs", LONG, Copy::deadlineNs),
            part("message", message, Copy::message),
            Copy::new),
        Shapes.of(
            GeocastMessage.<Ack<T>>type(Ack.class),
            part("id", GeocastId.SHAPE, Ack::id),
            Ack::new));
  }

  @SuppressWarnings("unchecked") // a class object has no type arguments
  private static <C> Class<C> type(Class<?> generic) {
    return (Class<C>) generic;
  }
}
