package org.starl.primitives.geocast;

import org.starl.GlobalVarHolder;
import org.starl.comms.Codec;
import org.starl.geometry.Circle;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/**
 * Messages to all other robots in an area (paper, section 4.2). The package's documentation is the
 * contract. Strand only.
 *
 * @param <T> the messages
 */
public final class Geocast<T> implements StarLPrimitive {

  private final GlobalVarHolder gvh;
  private final GeocastWire<T> wire;

  /**
   * @param xid the instance: robots with equal ones hear each other
   * @param codec copy with tags and area must fit a datagram
   * @param handler takes what others send to where this robot is
   */
  public Geocast(GlobalVarHolder gvh, String xid, Codec<T> codec, GeocastHandler<T> handler) {
    this(gvh, xid, codec, handler, GeocastSettings.DEFAULT);
  }

  public Geocast(
      GlobalVarHolder gvh,
      String xid,
      Codec<T> codec,
      GeocastHandler<T> handler,
      GeocastSettings settings) {
    this.gvh = gvh;
    wire = new GeocastWire<>(gvh, GeocastTrace.GEOCAST, xid, codec, handler, settings);
  }

  /**
   * Starts to send {@code message} to all other robots in {@code area}, and goes on for {@code dMs}
   * milliseconds from now (t0).
   *
   * @param dMs the paper's d, above 0
   * @throws IllegalArgumentException if a copy does not fit a datagram
   */
  public GeocastReceipt do_geocast(T message, Region area, long dMs) {
    return wire.start(GeocastTrace.DO_GEOCAST, message, area, dMs);
  }

  /**
   * A neighbourhood by distance: the disc around where this robot believes to be now. It stays
   * there when the robot goes on.
   *
   * @throws IllegalStateException without any fix yet
   */
  public Region neighbourhood(double radiusMm) {
    return new Circle(gvh.gps.pose().at(), radiusMm);
  }

  /** Whether this robot has started a geocast, and none of its geocasts is under way. */
  public GvhVariable<Boolean> Gcastflag() {
    return wire.gcastflag();
  }

  @Override
  public String source() {
    return wire.source();
  }

  @Override
  public void close() {
    wire.close();
  }
}
