package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotId;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.platform.Stable;
import org.starl.platform.Timer;

/**
 * Ties a protocol that stands on a {@link Synod} to its robot: channel, stable record, one timer.
 * Strand only.
 */
public final class SynodWire {

  private final GlobalVarHolder gvh;
  private final String stableKey;
  private final Timer timer;
  private final Endpoint<SynodMessage> endpoint;
  private @Nullable Client client;
  private long setForNs = Long.MAX_VALUE;
  private boolean closed;

  /** Opens the channel; before {@link #start}, the protocol may read and persist its record. */
  public SynodWire(GlobalVarHolder gvh, Channel<SynodMessage> channel) {
    this.gvh = gvh;
    this.stableKey = "synod/" + channel.name(); // names may have dots, but no slash
    this.timer = gvh.plat.timers.timer(this::expired);
    this.endpoint = gvh.comms.open(channel, this::received);
  }

  /** Begins to serve {@code protocol}; once, in the piece of the strand that made this wire. */
  public void start(Client protocol) {
    client = protocol;
    protocol.settled();
    rearm(protocol);
  }

  /** A protocol as its wire sees it. Times are now, in ns. */
  public interface Client {

    void received(RobotId from, SynodMessage message, long nowNs);

    void flushed(long version, long nowNs);

    void timer(long nowNs);

    /** When {@link #timer} is due; {@code Long.MAX_VALUE} for never. */
    long wakeAtNs();

    /** The protocol has taken an input and all its effects are out: show what has changed. */
    void settled();
  }

  /** What {@link #persist} has last written, or null; also before a restart. */
  public byte @Nullable [] record() {
    Stable stable = gvh.plat.stable;
    return stable.get(stableKey);
  }

  /** Calls the protocol; every call from outside goes this way, for the timer's sake. */
  public void call(Runnable action) {
    if (closed) {
      throw new IllegalStateException("a call after close()");
    }
    action.run();
    client().settled();
    rearm(client());
  }

  public void send(RobotId to, SynodMessage message) {
    endpoint.send(to, message);
  }

  /** Runs {@code settled} as an input once the message is delivered or given up. */
  public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
    endpoint.sendReliably(to, message).whenSettled(() -> input(settled));
  }

  public void persist(long version, byte[] record) {
    gvh.plat.stable.put(stableKey, record, () -> flushed(version));
  }

  /** Hears and sends nothing more; the acceptor's record stays. */
  public void close() {
    closed = true;
    timer.cancel();
    endpoint.close();
  }

  private void input(Runnable action) {
    if (!closed) {
      call(action);
    }
  }

  private void received(RobotId from, SynodMessage message) {
    input(() -> client().received(from, message, gvh.plat.clock.nowNs()));
  }

  private void flushed(long version) {
    input(() -> client().flushed(version, gvh.plat.clock.nowNs()));
  }

  private void expired() {
    setForNs = Long.MAX_VALUE;
    input(() -> client().timer(gvh.plat.clock.nowNs()));
  }

  private Client client() {
    Client started = client;
    if (started == null) {
      throw new IllegalStateException("not started");
    }
    return started;
  }

  private void rearm(Client protocol) {
    long wakeAtNs = protocol.wakeAtNs();
    if (closed || wakeAtNs == setForNs) {
      return;
    }
    setForNs = wakeAtNs;
    if (wakeAtNs == Long.MAX_VALUE) {
      timer.cancel();
    } else {
      timer.set(wakeAtNs);
    }
  }
}
