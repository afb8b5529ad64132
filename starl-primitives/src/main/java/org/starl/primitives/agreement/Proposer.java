package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.ObjLongConsumer;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.random.Rng;

/**
 * Works for the decision of one number at a time, ballot after ballot, until it is stopped. It repeats
 * its question to each acceptor until that answers. When a majority has become impossible, or one
 * acceptor has refused and others are silent, it pauses at random and begins a higher ballot.
 *
 * <p>Pure and clock-driven: {@link #timer} is due at {@link #wakeAtNs}.
 */
final class Proposer {

  private enum Phase {
    IDLE,
    PAUSING,
    PREPARING,
    ACCEPTING
  }

  private final ProcessId id;
  private final Participants acceptors;
  private final SynodTiming timing;
  private final Rng rng;
  private final BiConsumer<RobotId, SynodMessage> send;
  private final ObjLongConsumer<Value> chosen;

  private Phase phase = Phase.IDLE;
  private long number;
  private Value wish = Value.EMPTY;
  private Chooser chooser = wishes -> Value.EMPTY;

  // Never decreases, so this proposer uses no ballot twice.
  private long round;

  private Ballot ballot;
  private Value value = Value.EMPTY;
  private final Map<RobotId, Promise> promises = new TreeMap<>();
  private final Set<RobotId> votes = new TreeSet<>();
  private final Set<RobotId> refusals = new TreeSet<>();
  private int defeats;
  private long wakeAtNs = Long.MAX_VALUE;
  private long resendNs;

  /**
   * @param id used by no other proposer, ever
   * @param send sends, best effort
   * @param chosen a majority has accepted the value in one ballot: it is decided for this number
   */
  Proposer(
      ProcessId id,
      Participants acceptors,
      SynodTiming timing,
      Rng rng,
      BiConsumer<RobotId, SynodMessage> send,
      ObjLongConsumer<Value> chosen) {
    this.id = id;
    this.acceptors = acceptors;
    this.timing = timing;
    this.rng = rng;
    this.send = send;
    this.chosen = chosen;
    this.ballot = new Ballot(1, id);
  }

  /** Begins to work for a number, and stops working for the one before. */
  void propose(long aNumber, Value aWish, Chooser aChooser, long nowNs) {
    number = aNumber;
    wish = aWish;
    chooser = aChooser;
    defeats = 0;
    prepare(nowNs);
  }

  ProcessId id() {
    return id;
  }

  void stop() {
    phase = Phase.IDLE;
    wakeAtNs = Long.MAX_VALUE;
  }

  boolean isIdle() {
    return phase == Phase.IDLE;
  }

  /** The acceptors that have not answered the present ballot; none while it does not ask. */
  List<RobotId> unanswered() {
    List<RobotId> silent = new ArrayList<>();
    if (phase == Phase.PREPARING || phase == Phase.ACCEPTING) {
      Set<RobotId> answered = phase == Phase.PREPARING ? promises.keySet() : votes;
      for (RobotId acceptor : acceptors) {
        if (!answered.contains(acceptor) && !refusals.contains(acceptor)) {
          silent.add(acceptor);
        }
      }
    }
    return silent;
  }

  /** The number it works for, unless idle. */
  long number() {
    return number;
  }

  long wakeAtNs() {
    return wakeAtNs;
  }

  void timer(long nowNs) {
    if (nowNs < wakeAtNs) {
      return;
    }
    if (phase == Phase.PAUSING) {
      prepare(nowNs);
    } else if (!refusals.isEmpty()) {
      // The silent acceptors may be down: this ballot might wait for ever.
      pause(nowNs);
    } else if (phase != Phase.IDLE) {
      ask();
      resendNs = timing.nextResendNs(resendNs);
      wakeAtNs = nowNs + resendNs;
    }
  }

  void promise(RobotId from, Promise m, long nowNs) {
    if (phase != Phase.PREPARING || !isCurrent(from, m.number(), m.ballot())) {
      return;
    }
    refusals.remove(from);
    promises.put(from, m);
    if (isMajority(promises.size())) {
      value = valueToPropose();
      refusals.clear();
      begin(Phase.ACCEPTING, nowNs);
    }
  }

  void accepted(RobotId from, Accepted m) {
    if (phase != Phase.ACCEPTING || !isCurrent(from, m.number(), m.ballot())) {
      return;
    }
    votes.add(from);
    if (isMajority(votes.size())) {
      stop();
      chosen.accept(value, number);
    }
  }

  void nack(RobotId from, Nack m, long nowNs) {
    boolean asking = phase == Phase.PREPARING || phase == Phase.ACCEPTING;
    if (!asking || !isCurrent(from, m.number(), m.ballot())) {
      return;
    }
    round = Math.max(round, m.promised().round());
    refusals.add(from);
    if (!isMajority(acceptors.size() - refusals.size())) {
      pause(nowNs);
    }
  }

  /** Whether {@code message} has no effect, now and later: a ballot that is over never comes again. */
  boolean isSpent(SynodMessage message) {
    return switch (message) {
      case Promise m -> phase != Phase.PREPARING || !m.ballot().equals(ballot);
      case Accepted m -> phase != Phase.ACCEPTING || !m.ballot().equals(ballot);
      case Nack m -> phase == Phase.IDLE || phase == Phase.PAUSING || !m.ballot().equals(ballot);
      default -> false;
    };
  }

  /** The state without times and chooser: proposers with equal texts behave alike. */
  String state() {
    String asking = number + " " + wish + " " + ballot;
    return phase
        + " "
        + round
        + switch (phase) {
          case IDLE -> "";
          case PAUSING -> " " + number + " " + wish;
          case PREPARING -> " " + asking + promises + refusals;
          case ACCEPTING -> " " + asking + value + votes + refusals;
        };
  }

  private void pause(long nowNs) {
    defeats++;
    phase = Phase.PAUSING;
    wakeAtNs = nowNs + timing.backoffNs(defeats, rng);
  }

  private void prepare(long nowNs) {
    round++;
    ballot = new Ballot(round, id);
    promises.clear();
    votes.clear();
    refusals.clear();
    begin(Phase.PREPARING, nowNs);
  }

  private void begin(Phase next, long nowNs) {
    phase = next;
    ask();
    resendNs = timing.firstResendNs();
    wakeAtNs = nowNs + resendNs;
  }

  private void ask() {
    boolean preparing = phase == Phase.PREPARING;
    SynodMessage question =
        preparing ? new Prepare(number, ballot, wish) : new Accept(number, ballot, value);
    for (RobotId acceptor : unanswered()) {
      send.accept(acceptor, question);
    }
  }

  /** The vote of the highest ballot in the promises; an own value only if there is no vote. */
  private Value valueToPropose() {
    Vote highest = null;
    Set<Value> wishes = new LinkedHashSet<>();
    for (Promise promise : promises.values()) {
      Vote vote = promise.vote();
      if (vote != null && (highest == null || vote.ballot().compareTo(highest.ballot()) > 0)) {
        highest = vote;
      }
      wishes.addAll(promise.wishes());
    }
    List<Value> heard = new ArrayList<>(wishes);
    return highest != null ? highest.value() : chooser.choose(heard);
  }

  private boolean isCurrent(RobotId from, long itsNumber, Ballot itsBallot) {
    return itsNumber == number && itsBallot.equals(ballot) && acceptors.contains(from);
  }

  private boolean isMajority(int count) {
    return 2 * count > acceptors.size();
  }
}
