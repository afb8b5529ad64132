package org.starl.primitives.agreement;

import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.StarLPrimitive;

/**
 * Agreement on one value, once. Constructing it makes this robot serve as an acceptor if it is one;
 * {@link #propose} makes it work for a decision. Strand only.
 */
public final class SetAgreement implements StarLPrimitive {

  /** A proposal is given up after so long, in ms, unless told otherwise. */
  public static final long DEFAULT_DEADLINE_MS = 30_000;

  /** Action with the acceptors: this robot serves from now on, if it is one of them. */
  static final String ACCEPTORS = "acceptors";

  static final String PROPOSE = "propose";
  static final String DECIDED = "decided";
  static final String FAILED = "failed";

  private static final String PRIMITIVE = "agreement";
  private static final long NS_PER_MS = 1_000_000;
  private static final long ONLY_NUMBER = 1;

  private final GlobalVarHolder gvh;
  private final String source;
  private final Participants acceptors;
  private final long deadlineMs;
  private final GvhCell<Decision> decided;
  private final GvhCell<Boolean> failed;
  private final Protocol protocol;
  private final SynodWire wire;

  /** With all robots of the deployment as acceptors. */
  public SetAgreement(GlobalVarHolder gvh, String instance) {
    this(gvh, instance, gvh.id.participants(), SynodTiming.DEFAULT, DEFAULT_DEADLINE_MS);
  }

  /**
   * @param acceptors the same on every robot, for ever
   */
  public SetAgreement(
      GlobalVarHolder gvh,
      String instance,
      Participants acceptors,
      SynodTiming timing,
      long deadlineMs) {
    this.gvh = gvh;
    this.acceptors = acceptors;
    this.deadlineMs = deadlineMs;
    Channel<SynodMessage> channel =
        new Channel<>(PRIMITIVE, instance, new SynodCodec(SynodCodec.Format.anyValueNoWish()));
    source = channel.name();
    decided = gvh.variable(source, DECIDED, Decision.NONE_YET);
    failed = gvh.variable(source, FAILED, false);
    gvh.trace.action(source, ACCEPTORS, acceptors.asList().toArray());
    wire = new SynodWire(gvh, channel);
    protocol = new Protocol(timing);
    wire.start(protocol, this::show);
  }

  /**
   * Works for a decision, on {@code value} unless another one is ahead, until {@link #decided} or,
   * at the deadline, {@link #failed}; then it may be called again. Another call replaces the one before.
   * Once something is decided, a call changes nothing.
   *
   * @param value at most {@link Value#MAX_BYTES} bytes
   */
  public void propose(byte[] value) {
    Value proposed = Value.of(value);
    gvh.trace.action(source, PROPOSE, proposed);
    wire.call(nowNs -> protocol.propose(proposed, nowNs));
  }

  /** Asks the acceptors whether something is decided, without proposing anything. */
  public void refresh() {
    wire.call(nowNs -> protocol.synod.queryAll());
  }

  public GvhVariable<Decision> decided() {
    return decided;
  }

  /** Whether the latest proposal was given up at its deadline. */
  public GvhVariable<Boolean> failed() {
    return failed;
  }

  @Override
  public String source() {
    return source;
  }

  @Override
  public void close() {
    wire.close();
  }

  /** Whether {@code source} is one of these, as in {@code agreement/colour}. */
  static boolean isAgreement(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }

  private void show() {
    SynodMessage.Decided latest = protocol.synod.latest();
    if (latest != null) {
      decided.set(new Decision.Decided(latest.value()));
    }
    failed.set(protocol.gaveUp);
  }

  private final class Protocol implements SynodProtocol, SynodListener {
    private final Synod synod;
    private long deadlineNs = Long.MAX_VALUE;
    private boolean gaveUp;

    Protocol(SynodTiming timing) {
      synod =
          new Synod(
              gvh.id.name(),
              acceptors,
              gvh.id.freshProcess(),
              timing,
              gvh.plat.entropy.fork(source),
              wire,
              this);
    }

    void propose(Value value, long nowNs) {
      gaveUp = false;
      if (synod.latest() == null) {
        deadlineNs = nowNs + deadlineMs * NS_PER_MS;
        synod.propose(ONLY_NUMBER, Value.EMPTY, wishes -> value, nowNs);
      }
    }

    @Override
    public void received(RobotId from, SynodMessage message, long nowNs) {
      if (message.number() <= ONLY_NUMBER) {
        synod.received(from, message, nowNs);
      }
    }

    @Override
    public void flushed(long version, long nowNs) {
      synod.flushed(version);
    }

    @Override
    public void timer(long nowNs) {
      synod.timer(nowNs);
      if (nowNs >= deadlineNs) {
        deadlineNs = Long.MAX_VALUE;
        gaveUp = true;
        synod.stop();
      }
    }

    @Override
    public long wakeAtNs() {
      return Math.min(deadlineNs, synod.wakeAtNs());
    }

    @Override
    public void chosen(long number, Value value) {
      for (RobotId acceptor : acceptors) {
        if (!acceptor.equals(gvh.id.name())) {
          SynodMessage news = new SynodMessage.Decided(number, value);
          wire.sendReliably(acceptor, news, () -> {});
        }
      }
    }

    @Override
    public void learned(long number, Value value) {
      deadlineNs = Long.MAX_VALUE;
    }
  }
}
