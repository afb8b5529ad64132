package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.LongConsumer;
import java.util.function.ObjLongConsumer;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.trace.Instance;

/**
 * Connects a {@link SynodProtocol} to its robot: channels, stable storage, one timer. Strand only.
 */
public final class SynodWire implements SynodLink {

  private final GlobalVarHolder gvh;
  private final Instance source;
  private final String stableKey;
  private final Timer timer;
  private final Endpoint<SynodMessage> endpoint;
  private final List<Endpoint<?>> endpoints = new ArrayList<>();
  private @Nullable Started started;
  private boolean closed;

  /**
   * Opens the Synod's channel. The protocol may read and write its record from now on, and receives
   * messages from {@link #start} on.
   *
   * @param source the primitive's instance in the trace
   */
  public SynodWire(GlobalVarHolder gvh, Instance source, Channel<SynodMessage> channel) {
    this.gvh = gvh;
    this.source = source;
    this.stableKey = "synod/" + channel.name(); // names may have dots, but no slash
    this.timer = gvh.plat.timers.timer(this::expired);
    this.endpoint =
        gvh.comms.open(
            channel, (from, m) -> input(nowNs -> started().protocol().received(from, m, nowNs)));
    endpoints.add(endpoint);
  }

  /**
   * Opens a channel for the primitive's own messages; it closes with this wire.
   *
   * @param author the process in whose name a message is; a message in another robot's name is dropped
   * @param handler takes a message and the time, in ns
   */
  public <M> Endpoint<M> open(
      Channel<M> channel, Function<M, ProcessId> author, ObjLongConsumer<M> handler) {
    Endpoint<M> own =
        gvh.comms.open(
            channel,
            (from, message) -> {
              if (author.apply(message).robot().equals(from)) {
                input(nowNs -> handler.accept(message, nowNs));
              }
            });
    endpoints.add(own);
    return own;
  }

  /**
   * Starts {@code protocol}; once, in the strand piece that created this wire.
   *
   * @param settled shows what has changed: runs now, and after each input to the protocol
   */
  public void start(SynodProtocol protocol, Runnable settled) {
    started = new Started(protocol, settled);
    gvh.explain(() -> closed ? null : protocol.waitsFor(source));
    settle();
  }

  private record Started(SynodProtocol protocol, Runnable settled) {}

  @Override
  public byte @Nullable [] record() {
    return gvh.plat.stable.get(stableKey);
  }

  /**
   * Calls the protocol with the time, in ns. All calls of the app go through here, to keep the timer
   * right.
   *
   * @throws IllegalStateException after {@link #close}
   */
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
    gvh.plat.stable.put(
        stableKey, record, () -> input(nowNs -> started().protocol().flushed(version, nowNs)));
  }

  /** Stops sending and receiving. The acceptor's record remains. */
  public void close() {
    closed = true;
    timer.cancel();
    endpoints.forEach(Endpoint::close);
  }

  private void input(LongConsumer action) {
    if (!closed) {
      call(action);
    }
  }

  private void expired() {
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
    if (!closed) {
      timer.set(started().protocol().wakeAtNs());
    }
  }
}
