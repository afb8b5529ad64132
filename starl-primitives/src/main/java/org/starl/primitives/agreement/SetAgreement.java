package org.starl.primitives.agreement;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * Agreement on one value, once. A robot that constructs it serves as an acceptor, if it is
 * one; {@link #propose} makes it work for a decision. Strand only.
 */
public final class SetAgreement extends SynodPrimitive {

  /** The default time after which a proposal is given up, in ms. */
  public static final long DEFAULT_DEADLINE_MS = 30_000;

  /** Action with the acceptors: from now on this robot serves, if it is one of them. */
  static final String ACCEPTORS = "acceptors";

  static final String PROPOSE = "propose";
  /** Variable: the decision, or {@code null}. */
  public static final String DECIDED = "decided";
  static final String FAILED = "failed";

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "agreement";
  private static final long ONLY_NUMBER = 1;

  private final Participants acceptors;
  private final long deadlineMs;
  private final GvhCell<Decision> decided;
  private final GvhCell<Boolean> failed;
  private final Protocol protocol;

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
    super(
        gvh,
        PRIMITIVE + "/" + instance,
        new Channel<>(PRIMITIVE, instance, new SynodCodec(SynodCodec.Format.anyValueNoWish())));
    this.acceptors = acceptors;
    this.deadlineMs = deadlineMs;
    decided = gvh.variable(source, DECIDED, Decision.NONE_YET);
    failed = gvh.variable(source, FAILED, false);
    gvh.trace.action(source, ACCEPTORS, acceptors.asList().toArray());
    protocol = new Protocol(timing);
    wire.start(protocol, this::show);
  }

  /**
   * Works for a decision, on {@code value} unless another value is ahead, until {@link #decided} or,
   * at the deadline, {@link #failed}; then it may be called again. A new call replaces the one before.
   * After a decision, a call changes nothing.
   *
   * @param value at most {@link Value#MAX_BYTES} bytes
   */
  public void propose(byte[] value) {
    Value proposed = Value.of(value);
    gvh.trace.action(source, PROPOSE, proposed);
    wire.call(nowNs -> protocol.propose(proposed, nowNs));
  }

  /** Asks the acceptors for a decision, without proposing a value. */
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

  /** Whether {@code source} is an agreement, as in {@code agreement/colour}. */
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

  private final class Protocol extends SynodProtocol {
    private long deadlineNs = NEVER;
    private boolean gaveUp;

    Protocol(SynodTiming timing) {
      super(
          gvh.id.name(),
          acceptors,
          gvh.id.freshProcess(),
          timing,
          gvh.plat.entropy.fork(source),
          wire,
          gvh.plat.clock.nowNs());
    }

    void propose(Value value, long now) {
      gaveUp = false;
      if (synod.latest() == null) {
        deadlineNs = now + deadlineMs * NS_PER_MS;
        synod.propose(ONLY_NUMBER, Value.EMPTY, wishes -> value, now);
      }
    }

    @Override
    public void received(RobotId from, SynodMessage message, long now) {
      if (message.number() <= ONLY_NUMBER) {
        super.received(from, message, now);
      }
    }

    @Override
    public @Nullable Wait waitsFor(String name) {
      return gaveUp
          ? new Wait(name, "failed: no majority of the acceptors answered", List.of())
          : super.waitsFor(name);
    }

    @Override
    protected void ownTimers() {
      if (nowNs >= deadlineNs) {
        deadlineNs = NEVER;
        gaveUp = true;
        synod.stop();
      }
    }

    @Override
    protected long ownWakeAtNs() {
      return deadlineNs;
    }

    @Override
    public void chosen(long number, Value value) {
      for (RobotId acceptor : acceptors) {
        if (!acceptor.equals(gvh.id.name())) {
          wire.sendReliably(acceptor, new SynodMessage.Decided(number, value), () -> {});
        }
      }
    }

    @Override
    public void learned(long number, Value value) {
      deadlineNs = NEVER;
    }
  }
}
