package org.starl.primitives.agreement;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * A robot that runs a protocol over a Synod: its storage, of which a crash loses what is not flushed,
 * and its clock, through all starts of its program.
 *
 * <p>Its clock moves in two kinds of steps. After a pause each timer is due but that of a deadline,
 * which is later than all pauses of a search. So no due time is part of the state.
 *
 * @param <P> the protocol
 */
public abstract class SynodRobot<P extends SynodProtocol> implements SynodLink {

  /** A message on its way: of the Synod, or of the protocol itself. */
  public record Packet(int from, int to, Object content) {}

  /** The deadline of protocols, in ms. */
  public static final long DEADLINE_MS = 1_000_000_000;

  // More than any search has.
  private static final List<RobotId> ROBOTS =
      IntStream.range(0, 10).mapToObj(i -> new RobotId("bot" + i)).toList();

  // Longer than each wait but that for a deadline.
  private static final long PAUSE_MS = 20_000;

  public final RobotId name;

  /** The time on its clock. */
  protected long nowNs;

  /** The number of this robot. */
  protected final int me;

  private final Consumer<Packet> net;
  private final boolean isFlushSeen;
  // Writes that a crash loses, and the version of the last one that it does not lose.
  private final Deque<byte[]> unflushed = new ArrayDeque<>();
  private long flushedVersion;
  private byte @Nullable [] stored;
  private int starts;
  private int timers;
  private @Nullable P running;

  /**
   * @param isFlushSeen whether the moment of a flush makes a difference: only a crash shows it
   */
  protected SynodRobot(int me, Consumer<Packet> net, boolean isFlushSeen) {
    this.me = me;
    this.name = robot(me);
    this.net = net;
    this.isFlushSeen = isFlushSeen;
  }

  /** A protocol for the next start of the program. */
  protected abstract P begin(ProcessId id);

  /** Receives a message that is not of the Synod. */
  protected void received(Object message) {
    throw new IllegalArgumentException("not of the Synod: " + message);
  }

  /** The state of the protocol beside its Synod, and what observers know of this robot. */
  protected abstract String state();

  /** Records what the protocol shows: runs after each input. */
  protected void shown() {}

  /** Whether it waits for a deadline. */
  protected boolean hasDeadline() {
    return false;
  }

  /** The robot of this number. */
  public static RobotId robot(int i) {
    return ROBOTS.get(i);
  }

  /** The number of this robot. */
  public static int number(RobotId robot) {
    return ROBOTS.indexOf(robot);
  }

  /** The running program. */
  public final P protocol() {
    P program = running;
    if (program == null) {
      throw new IllegalStateException(name + " is not started");
    }
    return program;
  }

  /** Starts the program, again after a crash. */
  final void start() {
    unflushed.clear();
    flushedVersion = 0;
    starts++;
    running = begin(ProcessId.first(name, starts));
    settle();
  }

  /** The number of starts so far. */
  protected final int starts() {
    return starts;
  }

  final int timers() {
    return timers;
  }

  final void call(Runnable input) {
    input.run();
    settle();
  }

  final void receive(Packet packet) {
    if (packet.content() instanceof SynodMessage message) {
      call(() -> protocol().received(robot(packet.from()), message, nowNs));
    } else {
      call(() -> received(packet.content()));
    }
  }

  /** Its timers are due, and {@code withDeadline} that too; counted if it changes the state. */
  final void timer(boolean withDeadline) {
    String before = text();
    nowNs += (withDeadline ? 2 * DEADLINE_MS : PAUSE_MS) * NS_PER_MS;
    call(() -> protocol().timer(nowNs));
    timers += text().equals(before) ? 0 : 1;
  }

  final boolean mayFlush() {
    return !unflushed.isEmpty();
  }

  final void flush() {
    stored = unflushed.remove();
    flushedVersion++;
    protocol().flushed(flushedVersion, nowNs);
    shown();
  }

  private void settle() {
    shown();
    while (mayFlush() && !isFlushSeen) {
      flush();
    }
  }

  /** Whether {@code message} has no effect, now and later. */
  final boolean isSpent(Object message) {
    return message instanceof SynodMessage of
        && (protocol().synod.isSpent(of)
            || (of instanceof SynodMessage.Decided decree && isKept(decree.number())));
  }

  /** Whether it knows a decree of this number or a later one, also after a crash. */
  private boolean isKept(long number) {
    SynodMessage.Decided latest = protocol().synod.latest();
    boolean mayForget = isFlushSeen && (stored == null || mayFlush());
    return latest != null && latest.number() >= number && !mayForget;
  }

  /** All that decides what the robot does from now on, and what observers know of it. */
  final String text() {
    StringBuilder text = new StringBuilder();
    text.append(Arrays.toString(stored)).append(starts).append(timers);
    unflushed.forEach(write -> text.append(Arrays.toString(write)));
    return text.append(state()).append(protocol().synod.state()).toString();
  }

  /** Sends a message of the protocol itself. */
  protected final void transmit(RobotId to, Object message) {
    int recipient = number(to);
    // It makes no difference which robot tells a decree.
    int sender = message instanceof SynodMessage.Decided ? recipient : me;
    net.accept(new Packet(sender, recipient, message));
  }

  @Override
  public final void send(RobotId to, SynodMessage message) {
    transmit(to, message);
  }

  @Override
  public byte @Nullable [] record() {
    return stored;
  }

  @Override
  public final void persist(long version, byte[] record) {
    unflushed.add(record);
  }
}
