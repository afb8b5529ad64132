package org.starl.primitives.barrier;

import java.util.List;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodModel;
import org.starl.primitives.agreement.SynodRobot;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.random.Rng;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/** The states of robots that meet at a barrier. */
public class BarrierStates extends SynodModel<BarrierStates.Node> {

  /** Robots arrive in one generation after the other, and are told its outcome. */
  public static final StateSpace SPACE =
      space(
          "barrier",
          "a robot knows an outcome",
          BarrierStates::new,
          new Bound("generations", "generations in which a robot arrives", 1, 1, 3));

  static final BarrierSettings SETTINGS =
      BarrierSettings.DEFAULT.withDeadlineMs(SynodRobot.DEADLINE_MS);
  private static final Instance SOURCE = Instance.of(BarrierFact.PRIMITIVE, "states");

  private final int generations;

  BarrierStates(ToIntFunction<String> bounds) {
    super(bounds);
    generations = bounds.applyAsInt("generations");
  }

  /** The protocol; another one in a test. */
  BarrierProtocol program(ProcessId me, Node node, long nowNs) {
    return new BarrierProtocol(me, first(), SETTINGS, new Rng(1), node, node, nowNs);
  }

  /** A robot with its arrivals and what it was told. */
  final class Node extends SynodRobot<BarrierProtocol> implements BarrierPort {
    private final TreeSet<Long> arrivals = new TreeSet<>();
    private final TreeMap<String, BarrierOutcome> told = new TreeMap<>();

    Node(int me, Consumer<Packet> net) {
      super(me, net, mayCrash());
    }

    @Override
    protected BarrierProtocol begin(ProcessId id) {
      return program(id, this, nowNs);
    }

    private boolean mayArrive() {
      return !protocol().isWaiting()
          && protocol().generation() <= generations
          && !(protocol().outcome() instanceof BarrierOutcome.Excluded);
    }

    private void arrive() {
      if (starts() == 1) { // else it is no member
        arrivals.add(protocol().generation());
      }
      protocol().arrive(nowNs);
    }

    @Override
    protected void received(Object message) {
      protocol().received((BarrierMessage) message, nowNs);
    }

    @Override
    public void send(RobotId to, BarrierMessage message) {
      transmit(to, message);
    }

    @Override
    protected void shown() {
      BarrierOutcome outcome = protocol().outcome();
      told.put(starts() + "/" + outcome, outcome);
    }

    @Override
    protected String state() {
      return protocol().state() + arrivals + told.keySet();
    }

    @Override
    protected boolean hasDeadline() {
      return protocol().isWaiting();
    }
  }

  @Override
  protected Node create(int i, Consumer<SynodRobot.Packet> net) {
    return new Node(i, net);
  }

  @Override
  protected void addCalls(Node robot, BiConsumer<String, Consumer<Node>> calls) {
    if (robot.mayArrive()) {
      calls.accept("arrives", Node::arrive);
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    BarrierRecord record = new BarrierRecord(SOURCE, new FaultState());
    for (ProcessId id : first()) {
      record.created(id, first());
    }
    for (Node node : all) {
      ProcessId id = ProcessId.first(node.name, 1);
      node.arrivals.forEach(generation -> record.arrived(generation, id));
    }
    for (Node node : all) {
      for (BarrierOutcome told : node.told.values()) {
        record.told(new Variable(0, node.name, SOURCE, BarrierFact.OUTCOME, told), told, report);
      }
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream()
        .flatMap(node -> node.told.values().stream())
        .anyMatch(
            told -> told instanceof BarrierOutcome.Passed || told instanceof BarrierOutcome.Failed);
  }
}
