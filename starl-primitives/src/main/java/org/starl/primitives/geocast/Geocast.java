package org.starl.primitives.geocast;

import org.starl.GlobalVarHolder;
import org.starl.geometry.Circle;
import org.starl.geometry.Region;
import org.starl.shape.Shape;

/**
 * Messages to all other robots in an area (paper, section 4.2). The package's documentation is the
 * contract. Strand only.
 *
 * @param <T> the messages
 */
public final class Geocast<T> extends GeocastWire<T> {

  private final GlobalVarHolder gvh;

  /**
   * @param xid the instance: robots with equal ones receive each other's geocasts
   * @param shape of the messages; a copy with its tags and area must fit a datagram
   * @param handler receives the messages of others to this robot's place
   */
  public Geocast(GlobalVarHolder gvh, String xid, Shape<T> shape, GeocastHandler<T> handler) {
    this(gvh, xid, shape, handler, GeocastSettings.DEFAULT);
  }

  public Geocast(
      GlobalVarHolder gvh,
      String xid,
      Shape<T> shape,
      GeocastHandler<T> handler,
      GeocastSettings settings) {
    super(gvh, GeocastFact.GEOCAST, xid, shape, handler, settings);
    this.gvh = gvh;
  }

  /**
   * Sends {@code message} to all other robots in {@code area}, with repetitions for {@code dMs}
   * milliseconds from now (t0).
   *
   * @param dMs the paper's d, above 0
   * @throws IllegalArgumentException if a copy does not fit a datagram
   */
  public GeocastReceipt do_geocast(T message, Region area, long dMs) {
    return start(GeocastFact.do_geocast::new, message, area, dMs);
  }

  /**
   * The disc around this robot's estimated position now. It does not move with the robot.
   *
   * @throws IllegalStateException before the first fix
   */
  public Region neighbourhood(double radiusMm) {
    return new Circle(gvh.gps.pose().at(), radiusMm);
  }
}
