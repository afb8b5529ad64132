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
import org.starl.shape.Shape;
import org.starl.trace.Instance;

/**
 * Agreement on one value, once. A robot that constructs it serves as an acceptor, if it is
 * one; {@link #propose} makes it work for a decision. Strand only.
 *
 * @param <T> the values; equal ones must be written as equal bytes
 */
public final class SetAgreement<T> extends SynodPrimitive {

  private static final long ONLY_NUMBER = 1;

  private final Participants acceptors;
  private final Shape<T> shape;
  private final long deadlineMs;
  private final GvhCell<Decision<T>> decided;
  private final GvhCell<Boolean> failed;
  private final Protocol protocol;

  /**
   * With all robots of the deployment as acceptors.
   *
   * @param xid the instance: robots with equal ones agree with each other
   * @param shape of the values, in at most {@link Value#MAX_BYTES} bytes
   */
  public SetAgreement(GlobalVarHolder gvh, String xid, Shape<T> shape) {
    this(gvh, xid, shape, gvh.id.participants());
  }

  /**
   * @param acceptors the same on every robot, for ever; a decision needs a majority of them in reach
   */
  public SetAgreement(GlobalVarHolder gvh, String xid, Shape<T> shape, Participants acceptors) {
    this(gvh, xid, shape, acceptors, AgreementSettings.DEFAULT);
  }

  public SetAgreement(
      GlobalVarHolder gvh,
      String xid,
      Shape<T> shape,
      Participants acceptors,
      AgreementSettings settings) {
    super(
        gvh,
        Instance.of(AgreementFact.PRIMITIVE, xid),
        new Channel<>(AgreementFact.PRIMITIVE, xid, SynodCodec.of(SynodCodec.Format.of(shape))));
    this.shape = shape;
    this.acceptors = acceptors;
    this.deadlineMs = settings.deadlineMs();
    decided = gvh.variable(source, AgreementFact.decided(), new Decision.NoneYet<>());
    failed = gvh.variable(source, AgreementFact.FAILED, false);
    gvh.trace.action(
        source, AgreementFact.ACCEPTORS, new AgreementFact.Acceptors(acceptors.asList()));
    protocol = new Protocol(settings.timing());
    wire.start(protocol, this::show);
  }

  /**
   * Works for a decision, on {@code value} unless another value is ahead, until {@link #decided} or,
   * at the deadline, {@link #failed}; then it may be called again. A new call replaces the one before.
   * After a decision, a call changes nothing.
   *
   * @throws IllegalArgumentException if the shape does not write {@code value}, or writes more than
   *     {@link Value#MAX_BYTES} bytes
   */
  public void propose(T value) {
    Value proposed = Value.write(out -> shape.write(value, out));
    if (gvh.trace.isOn()) {
      gvh.trace.action(
          source,
          AgreementFact.PROPOSE,
          new AgreementAction.propose(gvh.id.name(), proposed.toString()));
    }
    wire.call(nowNs -> protocol.propose(proposed, nowNs));
  }

  /** Asks the acceptors for a decision, without proposing a value. */
  public void refresh() {
    wire.call(nowNs -> protocol.synod.queryAll());
  }

  /** The decision, once this robot knows it. */
  public GvhVariable<Decision<T>> decided() {
    return decided.variable();
  }

  /** Whether the latest proposal was given up at its deadline. */
  public GvhVariable<Boolean> failed() {
    return failed.variable();
  }

  private void show() {
    SynodMessage.Decided latest = protocol.synod.latest();
    if (latest != null && !decided.get().isDecided()) {
      Value bytes = latest.value();
      decided.set(new Decision.Decided<>(bytes.read(source.name(), shape::read), bytes));
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
          gvh.plat.entropy.fork(source.name()),
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
    public @Nullable Wait waitsFor(Instance agreement) {
      return gaveUp
          ? new Wait(agreement, "failed: no majority of the acceptors answered", List.of())
          : super.waitsFor(agreement);
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
