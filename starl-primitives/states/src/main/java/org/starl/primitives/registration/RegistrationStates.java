package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodModel;
import org.starl.primitives.agreement.SynodRobot;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.random.Rng;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/** The states of robots that register, leave, and are confined. */
public class RegistrationStates extends SynodModel<RegistrationStates.Node> {

  /** Robots enter and leave the views; a restarted one may say that its earlier ids hold nothing. */
  public static final StateSpace SPACE =
      space(
          "registration",
          "a robot is registered",
          RegistrationStates::new,
          new Bound("leaves", "1: a registered robot may unregister", 0, 0, 1),
          new Bound("confinements", "1: a registered robot may confine another id", 0, 0, 1),
          new Bound(
              "returns",
              "1: a restarted robot may say that its earlier ids hold nothing",
              0,
              0,
              1));

  // Registered robots ask after a rumour, and not again and again.
  static final RegistrationSettings SETTINGS =
      new RegistrationSettings(
          SynodTiming.DEFAULT, SynodRobot.DEADLINE_MS, 1_000, SynodRobot.DEADLINE_MS / 10);
  private static final SortedSet<String> SECTION = new TreeSet<>(List.of("A"));
  private static final Instance SOURCE = Instance.of(RegistrationFact.PRIMITIVE, "states");

  private final boolean mayLeave;
  private final boolean mayConfine;
  private final boolean mayStandIn;

  RegistrationStates(ToIntFunction<String> bounds) {
    super(bounds);
    mayLeave = bounds.applyAsInt("leaves") == 1;
    mayConfine = bounds.applyAsInt("confinements") == 1;
    mayStandIn = bounds.applyAsInt("returns") == 1;
  }

  /** The protocol; another one in a test. */
  RegistrationProtocol program(Node node, long nowNs) {
    return new RegistrationProtocol(node.name, names(), SETTINGS, new Rng(1), node, node, nowNs);
  }

  /** A robot with what it asked for, and the views that it knew. */
  final class Node extends SynodRobot<RegistrationProtocol> implements RegistrationPort {
    private final TreeSet<ProcessId> asked = new TreeSet<>();
    private final TreeSet<ProcessId> left = new TreeSet<>();
    private final TreeMap<String, Confinement> confined = new TreeMap<>();
    private final TreeMap<String, View> known = new TreeMap<>();
    private int ids;
    private boolean hasRegistered;
    private boolean hasStoodIn;

    Node(int me, Consumer<Packet> net) {
      super(me, net, mayCrash());
    }

    @Override
    protected RegistrationProtocol begin(ProcessId id) {
      ids = 0;
      hasRegistered = false;
      hasStoodIn = false;
      return program(this, nowNs);
    }

    private void register() {
      hasRegistered = true;
      protocol().do_register(nowNs);
    }

    private void unregister() {
      protocol().unregister(nowNs);
    }

    private boolean isBack() {
      return starts() > 1;
    }

    private void standIn() {
      hasStoodIn = true;
      protocol().standsIn(Sections.NONE, nowNs);
    }

    private void confine(ProcessId other) {
      TreeSet<ProcessId> fencers = new TreeSet<>(List.of(protocol().me()));
      protocol().confine(new Confinement(other, SECTION, fencers), nowNs);
    }

    @Override
    public ProcessId freshProcess() {
      long first = ProcessId.first(name, starts()).inc();
      return new ProcessId(name, first + ids++);
    }

    @Override
    public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
      send(to, message);
    }

    @Override
    public void acted(RegistrationAction action) {
      switch (action) {
        case RegistrationAction.do_register a -> asked.add(a.i());
        case RegistrationAction.unregister a -> left.add(a.i());
        case RegistrationAction.give_up a -> left.add(a.i());
        default -> throw new IllegalArgumentException(action.text());
      }
    }

    @Override
    public void confines(Confinement confinement) {
      confined.put(confinement.toString(), confinement);
    }

    @Override
    protected void shown() {
      View view = protocol().view();
      if (view.number() > 0) {
        known.put(view.toString(), view);
      }
    }

    @Override
    protected String state() {
      return protocol().state()
          + (ids + " " + hasRegistered + hasStoodIn + asked + left)
          + (confined.keySet() + " " + known.keySet());
    }

    @Override
    protected boolean hasDeadline() {
      return protocol().phase() == Phase.JOINING || protocol().phase() == Phase.LEAVING;
    }
  }

  @Override
  protected Node create(int i, Consumer<SynodRobot.Packet> net) {
    return new Node(i, net);
  }

  @Override
  protected void addCalls(Node robot, BiConsumer<String, Consumer<Node>> calls) {
    Phase phase = robot.protocol().phase();
    if (!robot.hasRegistered) {
      calls.accept("registers", Node::register);
    }
    if (mayLeave && (phase == Phase.IN || phase == Phase.LEFT_HALFWAY)) {
      calls.accept("unregisters", Node::unregister);
    }
    if (mayStandIn && robot.isBack() && !robot.hasStoodIn) {
      calls.accept("says that its earlier ids hold nothing", Node::standIn);
    }
    if (mayConfine && phase == Phase.IN && robot.confined.isEmpty()) {
      for (ProcessId other : robot.protocol().view().ids()) {
        if (!other.equals(robot.protocol().me())) {
          calls.accept("confines " + other, node -> node.confine(other));
        }
      }
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    ViewHistory history = new ViewHistory(SOURCE);
    for (Node node : all) {
      node.asked.forEach(id -> history.asked(node.name, id));
      node.left.forEach(id -> history.mayLeave(node.name, id));
      node.confined.values().forEach(each -> history.mayBeConfined(node.name, each));
    }
    for (Node node : all) {
      for (View view : node.known.values()) {
        history.learned(
            new Variable(0, node.name, SOURCE, RegistrationFact.VIEW, view), view, report);
      }
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> node.protocol().phase() == Phase.IN);
  }
}
