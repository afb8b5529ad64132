package org.starl.primitives.geocast;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Region;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.motion.Location;
import org.starl.platform.Timer;
import org.starl.primitives.StarLPrimitive;
import org.starl.shape.Shape;
import org.starl.trace.Instance;

/**
 * Connects a {@link GeocastProtocol} to its robot: channel, timer, position, trace. Strand only.
 */
abstract class GeocastWire<T> implements StarLPrimitive {

  private final GlobalVarHolder gvh;
  private final Instance source;
  private final GeocastHandler<T> handler;
  private final GeocastProtocol<T> protocol;
  private final Endpoint<GeocastMessage<T>> endpoint;
  private final Timer timer;
  private final GvhCell<Boolean> gcastflag;
  private boolean closed;

  GeocastWire(
      GlobalVarHolder gvh,
      String primitive,
      String xid,
      Shape<T> shape,
      GeocastHandler<T> handler,
      GeocastSettings settings) {
    this.gvh = gvh;
    this.handler = handler;
    ProcessId me = gvh.id.freshProcess();
    Channel<GeocastMessage<T>> channel = new Channel<>(primitive, xid, GeocastMessage.shape(shape));
    source = channel.instance();
    protocol = new GeocastProtocol<>(me, gvh.id.participants(), settings, new Port());
    gcastflag = gvh.variable(source, GeocastFact.GCASTFLAG, false);
    timer = gvh.plat.timers.timer(this::expired);
    endpoint = gvh.comms.open(channel, this::received);
    record(new GeocastFact.Opened(me));
  }

  /** The fact that a message starts: {@code do_geocast} or {@code BCast}. */
  @FunctionalInterface
  interface Start {
    GeocastFact of(GeocastId m, Region area, long bound);
  }

  final GeocastReceipt start(Start fact, T message, Region area, long dMs) {
    if (closed) {
      throw new IllegalStateException(source + " is closed");
    }
    if (dMs <= 0) {
      throw new IllegalArgumentException("d of " + dMs + " ms: expected above 0");
    }
    long dNs = Math.multiplyExact(dMs, NS_PER_MS);
    record(fact.of(protocol.nextId(), area, dNs));
    GeocastReceipt receipt = protocol.do_geocast(message, area, dNs, gvh.plat.clock.nowNs());
    settled();
    return receipt;
  }

  /** Whether this robot has sent a message in this instance, and the sending of all is complete. */
  public final GvhVariable<Boolean> Gcastflag() {
    return gcastflag.variable();
  }

  @Override
  public final Instance source() {
    return source;
  }

  @Override
  public final void close() {
    closed = true;
    timer.cancel();
    endpoint.close();
  }

  private void received(RobotId from, GeocastMessage<T> message) {
    long nowNs = gvh.plat.clock.nowNs();
    protocol.received(from, message, nowNs);
    protocol.timer(nowNs); // it may be due: the timer waits behind messages that came before it
    settled();
  }

  private void expired() {
    protocol.timer(gvh.plat.clock.nowNs());
    settled();
  }

  private void settled() {
    gcastflag.set(protocol.isComplete());
    if (!closed) {
      timer.set(protocol.wakeAtNs());
    }
  }

  private void record(GeocastFact fact) {
    gvh.trace.action(source, GeocastFact.SHAPE, fact);
  }

  private final class Port implements GeocastPort<T> {
    @Override
    public void broadcast(GeocastMessage.Copy<T> copy) {
      record(new GeocastFact.copy(copy.id()));
      endpoint.broadcast(copy);
    }

    @Override
    public void acknowledge(RobotId to, GeocastMessage.Ack<T> ack) {
      if (!closed) {
        endpoint.send(to, ack);
      }
    }

    @Override
    public double surelyInsideMm(Region area) {
      if (area instanceof Everywhere) {
        return Double.POSITIVE_INFINITY;
      }
      return switch (gvh.gps.location()) {
        case Location.Unknown unknown -> Double.NEGATIVE_INFINITY;
        case Location.Known known -> area.depthMm(known.pose().at()) - known.errorMm();
      };
    }

    @Override
    public void deliver(GeocastId id, T message) {
      record(new GeocastFact.deliver(id));
      handler.delivered(id.origin().robot(), message);
    }

    @Override
    public void dismissed(GeocastId id, Dismissal why) {
      if (gvh.trace.isOn()) {
        record(new GeocastFact.dismiss(id, why, gvh.gps.errorMm()));
      }
    }
  }
}
