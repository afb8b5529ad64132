package org.starl.primitives.agreement;

import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodAutomaton.Ballot;
import org.starl.primitives.agreement.SynodAutomaton.States;
import org.starl.primitives.agreement.SynodAutomaton.Vote;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Sent;

/**
 * Each decree of each {@link Synod} is a run of the protocol {@code Synod_decls}, of all primitives that
 * decide by one. The map, where {@code r} is the event's robot and {@code i} the ballot's proposer:
 *
 * <pre>
 * event               actions
 * Prepare sent        prepare(i, round), for the first time
 * Promise sent        Accept(r, its vote), if r has not answered it: r crashed before that, or waits for its
 *                     storage; Prepared(r, ballot); the promise tells vote(r)
 * Accept sent         wish(r, value), if nobody has; Propose(i, value, those whose promises allow it), for
 *                     the first time
 * Accepted sent       Accept(r, ballot, the ballot's value)
 * Decided sent        chosen(i, value, those that voted), if no decision is known; Learn(r, value), if r
 *                     does not know it
 * Decided delivered   Learn(r, value), if r does not know it
 * a crash, or Left    restart(r), if r knows the decision
 * </pre>
 *
 * <p>In real time the end of a killed process's trace may be missing: the replay of a decree ends with
 * the first message whose cause is not in the trace.
 */
public final class SynodConformance extends Conformance<SynodConformance.Run> {

  /** Older numbers are forgotten: no robot is so far behind, and runs may be long. */
  private static final int KEPT_NUMBERS = 256;

  private boolean isRealTime;

  public SynodConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every decree
   */
  public SynodConformance(AutomatonListener<States, SynodAction> steps) {
    super(
        SynodAutomaton.SYNOD_DECLS,
        "the messages of every Synod",
        source -> new Run(source, steps));
  }

  /** One channel. */
  static final class Run {
    private final Instance source;
    private final AutomatonListener<States, SynodAction> steps;
    private final Set<RobotId> acceptors = new TreeSet<>();
    private final TreeMap<Long, Decree> decrees = new TreeMap<>();

    private Run(Instance source, AutomatonListener<States, SynodAction> steps) {
      this.source = source;
      this.steps = steps;
    }

    private boolean isQuorum(SortedSet<RobotId> robots) {
      return 2 * robots.stream().filter(acceptors::contains).count() > acceptors.size();
    }

    /** What is replayed of this number; null if it is forgotten. */
    private @Nullable Decree decree(long number) {
      if (decrees.size() >= KEPT_NUMBERS && number < decrees.firstKey()) {
        return null;
      }
      Decree decree = decrees.computeIfAbsent(number, n -> new Decree(this));
      if (decrees.size() > KEPT_NUMBERS) {
        decrees.pollFirstEntry();
      }
      return decree;
    }
  }

  /** One number. */
  private static final class Decree {
    private final Run run;
    private final Replay<States, SynodAction> replay;
    private boolean isOver;

    Decree(Run run) {
      this.run = run;
      SynodAutomaton automaton = new SynodAutomaton((i, j) -> i.compareTo(j) < 0, run::isQuorum);
      replay = new Replay<>(automaton, run.source, run.steps);
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Sent sent when sent.message() instanceof SynodMessage message -> {
        Run run = instance(sent.channel());
        if (message instanceof Prepare) {
          // The first question of a ballot goes to all acceptors.
          run.acceptors.add(new RobotId(sent.to()));
        }
        Decree decree = run.decree(message.number());
        if (decree != null) {
          new Step(decree, sent, isRealTime, report).sent(message);
        }
      }
      case Delivered got when got.message() instanceof Decided message -> {
        Decree decree = instance(got.channel()).decree(message.number());
        if (decree != null) {
          new Step(decree, got, isRealTime, report).learn(message.value());
        }
      }
      case Fault fault when fault.name().equals(Fault.CRASH) -> ended(fault, report);
      case Fault fault -> isRealTime |= fault.isRealTime();
      case Left left -> ended(left, report);
      default -> {} // no action
    }
  }

  private void ended(TraceEvent event, Report report) {
    for (Run run : instances().values()) {
      for (Decree decree : run.decrees.values()) {
        if (decree.replay.state().decided().at(event.robot()).isUp()) {
          decree.replay.step(event, new SynodAction.restart(event.robot()), report);
        }
      }
    }
  }

  /** The actions of one event. */
  private record Step(Decree decree, TraceEvent event, boolean isRealTime, Report report) {

    void sent(SynodMessage message) {
      switch (message) {
        case Prepare m -> prepare(ballot(m.ballot()));
        case Promise m -> promise(ballot(m.ballot()), m.vote());
        case Accept m -> propose(new Vote(ballot(m.ballot()), m.value()));
        case Accepted m -> accept(asked(ballot(m.ballot())));
        case Decided m -> tell(m.value());
        case Nack m -> {} // changes nothing
        case Query m -> {} // of no decree
      }
    }

    private void prepare(Ballot b) {
      if (!state().prepares().contains(b)) {
        mustBeOf(b);
        take(new SynodAction.prepare(b.proposer(), b.round()), true);
      }
    }

    private void promise(Ballot b, SynodMessage.@Nullable Vote told) {
      Lift<Vote> vote =
          told == null
              ? new Lift.bottom<>()
              : new Lift.up<>(new Vote(ballot(told.ballot()), told.value()));
      if (vote.isUp() && !vote.equals(state().vote().at(robot()))) {
        accept(vote.get());
      }
      take(new SynodAction.Prepared(robot(), b), state().prepares().contains(b));
      if (!decree.isOver) {
        decree.replay.result(event, "vote", robot(), vote, state().vote().at(robot()), report);
      }
    }

    private void propose(Vote asked) {
      Ballot b = asked.ballot();
      if (!state().accepts().contains(asked)) {
        mustBeOf(b);
        if (!state().proposed().contains(asked.value())) {
          take(new SynodAction.wish(robot(), asked.value()), true);
        }
        SortedSet<RobotId> those = supporters(asked);
        take(
            new SynodAction.Propose(b.proposer(), asked.value(), those),
            decree.run.isQuorum(those));
      }
    }

    private void accept(Vote vote) {
      take(
          new SynodAction.Accept(robot(), vote.ballot(), vote.value()),
          state().accepts().contains(vote));
    }

    private void tell(Value value) {
      if (!state().decideds().contains(value)) {
        choose(value);
      }
      learn(value);
    }

    void learn(Value value) {
      if (!state().decided().at(robot()).equals(new Lift.up<>(value))) {
        take(new SynodAction.Learn(robot(), value), state().decideds().contains(value));
      }
    }

    /** By a proposer that asks for votes on this value, and for whose ballot a quorum voted, if there is one. */
    private void choose(Value value) {
      for (Vote asked : state().accepts()) {
        Ballot b = asked.ballot();
        SortedSet<RobotId> voters = voters(b);
        if (asked.value().equals(value)
            && state().ballot(b.proposer()).equals(b)
            && decree.run.isQuorum(voters)) {
          take(new SynodAction.chosen(b.proposer(), value, voters), true);
          return;
        }
      }
    }

    private SortedSet<RobotId> voters(Ballot b) {
      SortedSet<RobotId> voters = new TreeSet<>();
      for (SynodAutomaton.Accepted each : state().accepteds()) {
        if (each.ballot().equals(b)) {
          voters.add(each.acceptor());
        }
      }
      return voters;
    }

    /**
     * Those whose promises allow the value: they tell of no vote, or, if these are no quorum, of none above
     * the highest one for this value.
     */
    private SortedSet<RobotId> supporters(Vote asked) {
      SortedSet<RobotId> free = promised(asked.ballot(), vote -> false);
      Ballot highest = null;
      for (SynodAutomaton.Promise each : state().promises()) {
        if (each.ballot().equals(asked.ballot())
            && each.told().isUp()
            && each.told().get().value().equals(asked.value())) {
          Ballot told = each.told().get().ballot();
          highest = highest == null || told.compareTo(highest) > 0 ? told : highest;
        }
      }
      Ballot most = highest;
      return most == null || decree.run.isQuorum(free)
          ? free
          : promised(asked.ballot(), vote -> vote.ballot().compareTo(most) <= 0);
    }

    /** Those that promised {@code b}, and told of no vote, or of one with which the value may be proposed. */
    private SortedSet<RobotId> promised(Ballot b, Predicate<Vote> isLow) {
      SortedSet<RobotId> those = new TreeSet<>();
      for (SynodAutomaton.Promise each : state().promises()) {
        if (each.ballot().equals(b) && (!each.told().isUp() || isLow.test(each.told().get()))) {
          those.add(each.acceptor());
        }
      }
      return those;
    }

    /** What votes are asked for in {@code b}. */
    private Vote asked(Ballot b) {
      for (Vote asked : state().accepts()) {
        if (asked.ballot().equals(b)) {
          return asked;
        }
      }
      return new Vote(b, Value.EMPTY);
    }

    /** The message is the proposer's. */
    private void mustBeOf(Ballot b) {
      decree.replay.result(event, "proposer", b, robot(), b.proposer().robot(), report);
    }

    /**
     * @param hasCause whether the messages that it answers are in the trace
     */
    private void take(SynodAction action, boolean hasCause) {
      decree.isOver |= isRealTime && !hasCause;
      if (!decree.isOver) {
        decree.replay.step(event, action, report);
      }
    }

    private States state() {
      return decree.replay.state();
    }

    private RobotId robot() {
      return event.robot();
    }

    private static Ballot ballot(org.starl.primitives.agreement.Ballot of) {
      return new Ballot(of.round(), of.proposer());
    }
  }
}
