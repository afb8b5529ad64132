package org.starl.primitives.agreement;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;

/**
 * Agreement on one value, once. A robot that constructs it serves as an acceptor, if it is
 * one; {@link #propose} makes it work for a decision. Strand only.
 *
 * @param <T> the values; equal ones must be written as equal bytes
 */
public final class SetAgreement<T> extends SynodPrimitive {

  /** Action with the acceptors: from now on this robot serves, if it is one of them. */
  static final String ACCEPTORS = "acceptors";

  static final String PROPOSE = "propose";

  /** Variable: the decision, or {@code null}. */
  public static final String DECIDED = "decided";

  static final String FAILED = "failed";

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "agreement";

  private static final String IDLE = "IDLE";
  private static final String PROPOSING = "PROPOSING";
  private static final String HAS_DECIDED = "DECIDED";
  private static final String GAVE_UP = "FAILED";

  /** The phases: it has not proposed, proposes, knows the decision, or has given up. */
  public static final Phases PHASES =
      Phases.of(
          PRIMITIVE,
          SynodMessage.class,
          () -> SetAgreement::phase,
          IDLE,
          PROPOSING,
          HAS_DECIDED,
          GAVE_UP);

  private static final long ONLY_NUMBER = 1;

  private final Participants acceptors;
  private final Codec<T> codec;
  private final long deadlineMs;
  private final GvhCell<Decision<T>> decided;
  private final GvhCell<Boolean> failed;
  private final Protocol protocol;

  /**
   * With all robots of the deployment as acceptors.
   *
   * @param xid the instance: robots with equal ones agree with each other
   * @param codec encodes values, in at most {@link Value#MAX_BYTES} bytes
   */
  public SetAgreement(GlobalVarHolder gvh, String xid, Codec<T> codec) {
    this(gvh, xid, codec, gvh.id.participants());
  }

  /**
   * @param acceptors the same on every robot, for ever; a decision needs a majority of them in reach
   */
  public SetAgreement(GlobalVarHolder gvh, String xid, Codec<T> codec, Participants acceptors) {
    this(gvh, xid, codec, acceptors, AgreementSettings.DEFAULT);
  }

  public SetAgreement(
      GlobalVarHolder gvh,
      String xid,
      Codec<T> codec,
      Participants acceptors,
      AgreementSettings settings) {
    super(
        gvh,
        PRIMITIVE + "/" + xid,
        new Channel<>(PRIMITIVE, xid, new SynodCodec(SynodCodec.Format.of(codec))));
    this.codec = codec;
    this.acceptors = acceptors;
    this.deadlineMs = settings.deadlineMs();
    decided = gvh.variable(source, DECIDED, new Decision.NoneYet<>());
    failed = gvh.variable(source, FAILED, false);
    gvh.trace.action(source, ACCEPTORS, acceptors.asList().toArray());
    protocol = new Protocol(settings.timing());
    wire.start(protocol, this::show);
  }

  /**
   * Works for a decision, on {@code value} unless another value is ahead, until {@link #decided} or,
   * at the deadline, {@link #failed}; then it may be called again. A new call replaces the one before.
   * After a decision, a call changes nothing.
   *
   * @throws IllegalArgumentException if the codec does not write {@code value}, or writes more than
   *     {@link Value#MAX_BYTES} bytes
   */
  public void propose(T value) {
    Value proposed = Value.write(out -> codec.write(value, out));
    gvh.trace.action(source, PROPOSE, proposed);
    wire.call(nowNs -> protocol.propose(proposed, nowNs));
  }

  /** Asks the acceptors for a decision, without proposing a value. */
  public void refresh() {
    wire.call(nowNs -> protocol.synod.queryAll());
  }

  /** The decision, once this robot knows it. */
  public GvhVariable<Decision<T>> decided() {
    return decided;
  }

  /** Whether the latest proposal was given up at its deadline. */
  public GvhVariable<Boolean> failed() {
    return failed;
  }

  private static String phase(String before, String name, List<String> texts) {
    boolean hasDecided = before.equals(HAS_DECIDED);
    return switch (name) {
      case PROPOSE -> hasDecided ? before : PROPOSING;
      case DECIDED -> texts.get(0).equals("null") ? before : HAS_DECIDED;
      case FAILED -> texts.get(0).equals("true") && !hasDecided ? GAVE_UP : before;
      default -> before;
    };
  }

  /** Whether {@code source} is an agreement, as in {@code agreement/colour}. */
  static boolean isAgreement(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }

  private void show() {
    SynodMessage.Decided latest = protocol.synod.latest();
    if (latest != null && !decided.get().isDecided()) {
      Value bytes = latest.value();
      decided.set(new Decision.Decided<>(bytes.read(source, codec::read), bytes));
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
