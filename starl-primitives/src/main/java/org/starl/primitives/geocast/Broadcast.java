package org.starl.primitives.geocast;

import org.starl.GlobalVarHolder;
import org.starl.geometry.Everywhere;
import org.starl.shape.Shape;

/**
 * Messages to all other robots (paper, section 4.2: {@code BCast}): a geocast to the whole network.
 * A receiver needs no position. Strand only.
 *
 * @param <T> the messages
 */
public final class Broadcast<T> extends GeocastWire<T> {

  /**
   * @param xid the instance: robots with equal ones receive each other's broadcasts, and no {@link
   *     Geocast}
   * @param shape of the messages; a copy with its tags must fit a datagram
   * @param handler receives the messages of others
   */
  public Broadcast(GlobalVarHolder gvh, String xid, Shape<T> shape, GeocastHandler<T> handler) {
    this(gvh, xid, shape, handler, GeocastSettings.DEFAULT);
  }

  public Broadcast(
      GlobalVarHolder gvh,
      String xid,
      Shape<T> shape,
      GeocastHandler<T> handler,
      GeocastSettings settings) {
    super(gvh, GeocastFact.BROADCAST, xid, shape, handler, settings);
  }

  /**
   * Sends {@code message} to all other robots, with repetitions for {@code dMs} milliseconds.
   *
   * @param dMs the paper's d, above 0
   * @throws IllegalArgumentException if a copy does not fit a datagram
   */
  public GeocastReceipt BCast(T message, long dMs) {
    return start(GeocastFact.BCast::new, message, new Everywhere(), dMs);
  }
}
