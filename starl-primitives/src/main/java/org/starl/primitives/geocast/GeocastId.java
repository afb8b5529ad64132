package org.starl.primitives.geocast;

import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The globally unique id of a geocast.
 *
 * @param origin the incarnation that started it
 * @param number counts the origin's geocasts, from 1
 */
public record GeocastId(ProcessId origin, long number) {

  /** Its shape. */
  public static final Shape<GeocastId> SHAPE =
      Shapes.of(
          GeocastId.class,
          part("origin", Shapes.PROCESS, GeocastId::origin),
          part("number", Shapes.atLeast(1, "geocast number"), GeocastId::number),
          GeocastId::new);

  public GeocastId {
    if (number <= 0) {
      throw new IllegalArgumentException("geocast number " + number + ": expected above 0");
    }
  }

  /** For people, and in the theory: {@code bot3/7}. */
  @Override
  public String toString() {
    return origin + "/" + number;
  }
}
