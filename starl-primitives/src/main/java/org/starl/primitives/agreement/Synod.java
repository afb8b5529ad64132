package org.starl.primitives.agreement;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.random.Rng;
import org.starl.shape.WireFormatException;

/**
 * One robot's part in a sequence of decrees: proposer, acceptor if it is one, and learner (Lamport,
 * "The part-time parliament", ACM Transactions on Computer Systems 16(2), 1998; the single-decree
 * Synod of its section 2, once a number).
 *
 * <p>For each number at most one value is ever decided, whatever is lost, late, doubled, reordered,
 * and whichever robots crash and restart. A learner may skip numbers, so with more than one number
 * each value must be complete by itself.
 *
 * <p>Pure and clock-driven: calls, messages and timers in, effects out through a {@link SynodLink}
 * and a {@link SynodListener}; {@link #timer} is due at {@link #wakeAtNs}, which every call may change.
 */
public final class Synod {

  private final SynodLink link;
  private final SynodListener listener;
  private final Participants acceptors;
  private final Proposer proposer;
  private final @Nullable Acceptor acceptor;
  private @Nullable Decided latest;

  /**
   * @param acceptors the robots that vote; the same on every robot, for ever
   * @param proposerId used by no other proposer, ever
   * @throws IllegalStateException if the acceptor's record is damaged: an acceptor that has lost its
   *     memory must never vote again
   */
  public Synod(
      RobotId self,
      Participants acceptors,
      ProcessId proposerId,
      SynodTiming timing,
      Rng rng,
      SynodLink link,
      SynodListener listener) {
    if (acceptors.size() == 0) {
      throw new IllegalArgumentException("no acceptors: expected at least one");
    }
    this.link = link;
    this.listener = listener;
    this.acceptors = acceptors;
    this.proposer = new Proposer(proposerId, acceptors, timing, rng, link::send, this::chosen);
    this.acceptor = acceptors.contains(self) ? new Acceptor(restored(link.record()), link) : null;
    this.latest = acceptor == null ? null : acceptor.decided();
  }

  /** The id of this robot's proposer. */
  public ProcessId proposerId() {
    return proposer.id();
  }

  /** The latest decree known to this robot, or null. */
  public @Nullable Decided latest() {
    return latest;
  }

  /**
   * Works for a decision of {@code number}, and no longer for an earlier call's, until that number or
   * a later one is learned, or until {@link #stop}. The decided value may be another proposer's.
   *
   * @param number above all that are known to be decided
   * @param wish a request that other proposers of the same number may fulfil; empty for none
   */
  public void propose(long number, Value wish, Chooser chooser, long nowNs) {
    Decided known = latest;
    if (number < 1 || (known != null && number <= known.number())) {
      throw new IllegalArgumentException("decree " + number + " is decided, or below 1");
    }
    proposer.propose(number, wish, chooser, nowNs);
  }

  /** Stops working for a decision; its proposals may still be decided. */
  public void stop() {
    proposer.stop();
  }

  /** Whether it is working for a decision. */
  public boolean isProposing() {
    return !proposer.isIdle();
  }

  /** The acceptors whose answers it waits for while it works for a decision. */
  public List<RobotId> unanswered() {
    return proposer.unanswered();
  }

  /** Learns a decree from another source, such as the deployment's first value. */
  public void learn(long number, Value value) {
    Decided known = latest;
    if (known != null && number <= known.number()) {
      return;
    }
    Decided decree = new Decided(number, value);
    latest = decree;
    if (acceptor != null) {
      acceptor.decided(decree);
    }
    if (!proposer.isIdle() && proposer.number() <= number) {
      proposer.stop();
    }
    listener.learned(number, value);
  }

  /** Asks {@code acceptor} for its latest decree, if that is later than this robot's. */
  public void query(RobotId acceptor) {
    Decided known = latest;
    link.send(acceptor, new Query(known == null ? 0 : known.number()));
  }

  /** Asks all acceptors. */
  public void queryAll() {
    for (RobotId each : acceptors) {
      query(each);
    }
  }

  public void received(RobotId from, SynodMessage message, long nowNs) {
    switch (message) {
      case Prepare m -> {
        if (acceptor != null) {
          acceptor.prepare(from, m);
        }
        heardOf(m.number());
      }
      case Accept m -> {
        if (acceptor != null) {
          acceptor.accept(from, m);
        }
        heardOf(m.number());
      }
      case Promise m -> proposer.promise(from, m, nowNs);
      case Accepted m -> proposer.accepted(from, m);
      case Nack m -> proposer.nack(from, m, nowNs);
      case Decided m -> learn(m.number(), m.value());
      case Query m -> answer(from, m);
    }
  }

  /** The acceptor's record of {@code version}, and all before it, would survive a crash. */
  public void flushed(long version) {
    if (acceptor != null) {
      acceptor.flushed(version);
    }
  }

  public void timer(long nowNs) {
    proposer.timer(nowNs);
  }

  /** When {@link #timer} is due; {@code Long.MAX_VALUE} for never. */
  public long wakeAtNs() {
    return proposer.wakeAtNs();
  }

  /** The state without times: robots with equal texts behave alike. */
  String state() {
    return proposer.state() + (acceptor == null ? "" : acceptor.state()) + latest;
  }

  /** Whether {@code message} has no effect, now and later. */
  boolean isSpent(SynodMessage message) {
    return proposer.isSpent(message);
  }

  private void heardOf(long number) {
    Decided known = latest;
    if (known == null || number > known.number()) {
      listener.rumour(number);
    }
  }

  private void answer(RobotId from, Query m) {
    Decided known = latest;
    if (known != null && known.number() > m.number()) {
      link.send(from, known);
    }
  }

  private static AcceptorRecord restored(byte @Nullable [] record) {
    try {
      return record == null ? AcceptorRecord.NEW : AcceptorRecord.fromBytes(record);
    } catch (WireFormatException e) {
      throw new IllegalStateException("the acceptor's stable record is damaged", e);
    }
  }

  private void chosen(Value value, long number) {
    listener.chosen(number, value);
    learn(number, value);
  }
}
