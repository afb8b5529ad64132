package org.starl.primitives.election;

import java.util.List;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodModel;
import org.starl.primitives.agreement.SynodRobot;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.random.Rng;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/**
 * The states of robots that elect leaders. Where a strategy chooses when to propose a candidate, and
 * which, it may be at any time: so draws make no difference.
 */
public class ElectionStates extends SynodModel<ElectionStates.Node> {

  /** Robots elect a leader, and the next one when it is suspected. */
  public static final StateSpace SPACE =
      space(
          "election",
          "a robot knows a leader",
          ElectionStates::new,
          new Bound("others", "1: a robot also proposes other candidates", 0, 0, 1));

  // The strategy has no turn before the deadline.
  static final ElectionSettings SETTINGS =
      new ElectionSettings(
          ElectionStrategy.BULLY,
          SynodTiming.DEFAULT,
          SynodRobot.DEADLINE_MS / 10,
          250,
          2_500,
          SynodRobot.DEADLINE_MS);
  private static final Instance SOURCE = Instance.of(ElectionFact.PRIMITIVE, "states");

  private final boolean proposesOthers;

  ElectionStates(ToIntFunction<String> bounds) {
    super(bounds);
    proposesOthers = bounds.applyAsInt("others") == 1;
  }

  /** The protocol; another one in a test. */
  ElectionProtocol program(ProcessId me, Node node, long nowNs) {
    return new ElectionProtocol(me, names(), SETTINGS, new Rng(1), node, node, nowNs);
  }

  /** A robot with the terms in which it stood, and the leaders that it knew. */
  final class Node extends SynodRobot<ElectionProtocol> implements ElectionPort {
    private final TreeMap<ProcessId, TreeSet<Long>> stood = new TreeMap<>();
    private final TreeMap<String, Leader.Name> known = new TreeMap<>();
    private boolean hasCalled;
    private long latestTerm;
    private boolean hasGoneBack;
    private @Nullable ProcessId proposal;

    Node(int me, Consumer<Packet> net) {
      super(me, net, mayCrash());
    }

    @Override
    protected ElectionProtocol begin(ProcessId id) {
      hasCalled = false;
      latestTerm = 0;
      return program(id, this, nowNs);
    }

    private void stand() {
      hasCalled = true;
      protocol().do_election(nowNs);
    }

    private void propose(ProcessId candidate) {
      proposal = candidate;
      protocol().propose(candidate);
    }

    @Override
    public void candidate(long term) {
      if (hasCalled) {
        stood.computeIfAbsent(protocol().me(), id -> new TreeSet<>()).add(term);
      }
    }

    @Override
    protected void received(Object message) {
      protocol().received((ElectionMessage) message, nowNs);
    }

    @Override
    public void send(RobotId to, ElectionMessage message) {
      transmit(to, message instanceof Candidacy m ? new Candidacy(m.from(), m.term(), 0) : message);
    }

    @Override
    public void broadcast(ElectionMessage message) {
      for (RobotId to : names()) {
        if (!to.equals(name)) {
          send(to, message);
        }
      }
    }

    @Override
    protected void shown() {
      if (protocol().leader() instanceof Leader.Name name) {
        known.put(name.toString(), name);
        hasGoneBack |= name.term() < latestTerm;
      }
      latestTerm = protocol().term();
      proposal = hasDeadline() && protocol().choices().isEmpty() ? proposal : null;
    }

    @Override
    protected String state() {
      return protocol().state() + hasCalled + proposal + stood + known + latestTerm;
    }

    @Override
    protected boolean hasDeadline() {
      return hasCalled && protocol().leader() instanceof Leader.None;
    }
  }

  @Override
  protected Node create(int i, Consumer<SynodRobot.Packet> net) {
    return new Node(i, net);
  }

  @Override
  protected void addCalls(Node robot, BiConsumer<String, Consumer<Node>> calls) {
    if (!robot.hasCalled || robot.protocol().leader() instanceof Leader.Fail) {
      calls.accept("calls do_election", Node::stand);
    }
    for (ProcessId each : robot.protocol().choices()) {
      if (proposesOthers || each.equals(robot.protocol().me())) {
        calls.accept("proposes " + each, node -> node.propose(each));
      }
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    ElectionRecord record = new ElectionRecord(SOURCE, new FaultState());
    for (Node node : all) {
      record.called(node.name);
      node.stood.forEach((id, terms) -> terms.forEach(term -> record.stood(term, id)));
    }
    for (Node node : all) {
      for (Leader.Name led : node.known.values()) {
        record.ended(node.name); // the node itself compares its terms
        record.shown(new Variable(0, node.name, SOURCE, ElectionFact.LEADER, led), led, report);
      }
      if (node.hasGoneBack) {
        report.violated(ElectionSpec.TERMS, 0, List.of(), node.name + " shows an earlier term");
      }
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> !node.known.isEmpty());
  }
}
