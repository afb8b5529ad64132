package org.starl.primitives.agreement;

import java.util.function.LongConsumer;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.platform.Stable;
import org.starl.platform.Timer;

/**
 * Ties a protocol that stands on a {@link Synod} to its robot: channel, stable record, one timer.
 * Strand only.
 */
public final class SynodWire implements SynodLink {

  private final GlobalVarHolder gvh;
  private final String stableKey;
  private final Timer timer;
  private final Endpoint<SynodMessage> endpoint;
  private @Nullable Started started;
  private long setForNs = Long.MAX_VALUE;
  private boolean closed;

  /** Opens the channel; before {@link #start}, the protocol may read and persist its record. */
  public SynodWire(GlobalVarHolder gvh, Channel<SynodMessage> channel) {
    this.gvh = gvh;
    this.stableKey = "synod/" + channel.name(); // names may have dots, but no slash
    this.timer = gvh.plat.timers.timer(this::expired);
    this.endpoint = gvh.comms.open(channel, this::received);
  }

  /**
   * Begins to serve {@code protocol}; once, in the piece of the strand that made this wire.
   *
   * @param settled shows what has changed: runs now, and whenever the protocol has taken an input and
   *     all its effects are out
   */
  public void start(SynodProtocol protocol, Runnable settled) {
    started = new Started(protocol, settled);
    settle();
  }

  private record Started(SynodProtocol protocol, Runnable settled) {}

  @Override
  public byte @Nullable [] record() {
    Stable stable = gvh.plat.stable;
    return stable.get(stableKey);
  }

  /** Calls the protocol, now in ns; every call from outside goes this way, for the timer's sake. */
  public void call(LongConsumer action) {
    if (closed) {
      throw new IllegalStateException("a call after close()");
    }
    action.accept(gvh.plat.clock.nowNs());
    settle();
  }

  @Override
  public void send(RobotId to, SynodMessage message) {
    endpoint.send(to, message);
  }

  /** Runs {@code settled} as an input once the message is delivered or given up. */
  public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
    endpoint.sendReliably(to, message).whenSettled(() -> input(nowNs -> settled.run()));
  }

  @Override
  public void persist(long version, byte[] record) {
    gvh.plat.stable.put(stableKey, record, () -> flushed(version));
  }

  /** Hears and sends nothing more; the acceptor's record stays. */
  public void close() {
    closed = true;
    timer.cancel();
    endpoint.close();
  }

  private void input(LongConsumer action) {
    if (!closed) {
      call(action);
    }
  }

  private void received(RobotId from, SynodMessage message) {
    input(nowNs -> started().protocol().received(from, message, nowNs));
  }

  private void flushed(long version) {
    input(nowNs -> started().protocol().flushed(version, nowNs));
  }

  private void expired() {
    setForNs = Long.MAX_VALUE;
    input(nowNs -> started().protocol().timer(nowNs));
  }

  private Started started() {
    Started known = started;
    if (known == null) {
      throw new IllegalStateException("not started");
    }
    return known;
  }

  private void settle() {
    started().settled().run();
    long wakeAtNs = started().protocol().wakeAtNs();
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
