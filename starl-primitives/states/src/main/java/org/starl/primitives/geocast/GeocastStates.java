package org.starl.primitives.geocast;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.RobotModel;
import org.starl.primitives.agreement.SynodRobot;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.spec.Monitor;
import org.starl.spec.Monitor.Report;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The states of robots that send geocasts. The clocks go on by ticks, each at any time, but none is
 * more than a tick ahead of another: the skew that the settings allow. A tick is longer than each
 * wait for a repetition.
 */
public class GeocastStates extends RobotModel<GeocastStates.Node> {

  /** Robots send to an area, into which and out of which they move, and start again. */
  public static final StateSpace SPACE =
      new StateSpace(
          "geocast",
          "a robot has delivered a message",
          List.of(
              new Bound("robots", "robots", 1, 2, 4),
              new Bound("crashes", "crashes, each with a restart", 0, 0, 4),
              new Bound("callers", "robots that send; 0: all", 0, 0, 4),
              new Bound("casts", "messages that a robot sends in one start", 1, 1, 3),
              new Bound("outside", "robots outside the area at the start", 0, 0, 4),
              new Bound("moves", "moves into the area, or out of it", 0, 0, 4),
              new Bound("ticks", "of each clock; a message ends 2 ticks after its start", 0, 0, 6),
              new Bound("broadcast", "1: the area is everywhere", 0, 0, 1)),
          bounds -> new StateSearch<>(new GeocastStates(bounds)));

  static final long TICK_NS = 2 * Time.NS_PER_S;
  static final GeocastSettings SETTINGS = GeocastSettings.DEFAULT.withClockSkewNs(TICK_NS);

  private static final double ERROR_MM = 50;
  private static final double RADIUS_MM = 1_000;
  private static final long END_NS = Time.NS_PER_S * 1_000;

  // A robot's first events are that it is there and takes part: before all others of all robots.
  private static final int BEGUN = 2;

  private static final Shape<GeocastMessage<String>> MESSAGE = GeocastMessage.shape(Shapes.TEXT);

  private final Region area;
  private final Instance source;

  GeocastStates(ToIntFunction<String> bounds) {
    super(bounds);
    boolean toAll = bound("broadcast") == 1;
    area = toAll ? new Everywhere() : new Circle(new Point(0, 0), RADIUS_MM);
    source = Instance.of(toAll ? GeocastFact.BROADCAST : GeocastFact.GEOCAST, "states");
  }

  /** The protocol; another one in a test. */
  GeocastProtocol<String> program(ProcessId me, Node node) {
    return new GeocastProtocol<>(me, names(), SETTINGS, node);
  }

  /**
   * What the specification reads of a robot, on its own clock.
   *
   * @param sender of the message that it is about, or {@link Fault#WORLD}
   */
  private record Noted(RobotId sender, TraceEvent event) {}

  /** A robot with its body, through all starts of its program. */
  final class Node implements GeocastPort<String> {
    private final int me;
    private final RobotId name;
    private final Consumer<Packet> net;
    private final List<Noted> history = new ArrayList<>();
    // The messages of this start that are in the history: each once.
    private final Set<String> seen = new TreeSet<>();
    private boolean isInside;
    private boolean isComplete;
    private long nowNs;
    private int starts;
    private int moved;
    private int deliveries;
    private GeocastProtocol<String> protocol;

    Node(int me, Consumer<Packet> net) {
      this.me = me;
      this.net = net;
      name = SynodRobot.robot(me);
      isInside = me < size() - bound("outside");
      note(Fault.WORLD, new Joined(0, name, pose(), 1));
      protocol = start();
    }

    private GeocastProtocol<String> start() {
      starts++;
      seen.clear();
      ProcessId id = ProcessId.first(name, starts);
      act(Fault.WORLD, new GeocastFact.Opened(id));
      show(false);
      return program(id, this);
    }

    private void restart() {
      note(Fault.WORLD, new Fault(nowNs, name, Fault.CRASH, ""));
      note(Fault.WORLD, new Fault(nowNs, name, Fault.RESTART, ""));
      protocol = start();
    }

    private void move() {
      moved++;
      isInside = !isInside;
      note(Fault.WORLD, new Moved(nowNs, name, pose(), 0, 0));
    }

    private Pose pose() {
      return new Pose(isInside ? 0 : 2 * RADIUS_MM, 0, 0);
    }

    private void send() {
      GeocastId id = protocol.nextId();
      long dNs = 2 * TICK_NS;
      act(
          name,
          area instanceof Everywhere
              ? new GeocastFact.BCast(id, area, dNs)
              : new GeocastFact.do_geocast(id, area, dNs));
      protocol.do_geocast("", area, dNs, nowNs);
      settle();
    }

    private void timer() {
      protocol.timer(nowNs);
      settle();
    }

    private boolean isDue() {
      return nowNs >= protocol.wakeAtNs();
    }

    private void receive(RobotId from, GeocastMessage<String> message) {
      boolean isCopy = message instanceof GeocastMessage.Copy;
      // A copy that finds the robot outside requires nothing.
      if (!isCopy || surelyInsideMm(area) > 0) {
        noteOnce(new Delivered(nowNs, name, from, source, 0, MESSAGE, message), message);
      }
      protocol.received(from, message, nowNs);
      settle();
    }

    private void settle() {
      if (protocol.isComplete() != isComplete) {
        show(!isComplete);
      }
    }

    private void show(boolean complete) {
      isComplete = complete;
      note(name, new Variable(nowNs, name, source, GeocastFact.GCASTFLAG, complete));
    }

    private void act(RobotId sender, GeocastFact fact) {
      note(sender, Action.of(nowNs, name, source, GeocastFact.SHAPE, fact));
    }

    private void note(RobotId sender, TraceEvent event) {
      history.add(new Noted(sender, event));
    }

    private void noteOnce(TraceEvent event, GeocastMessage<String> message) {
      if (seen.add(event.at(0).toString())) {
        note(message.id().origin().robot(), event);
      }
    }

    private Sent sent(String to, GeocastMessage<String> message) {
      return new Sent(nowNs, name, to, source, 0, 0, MESSAGE, message);
    }

    @Override
    public void broadcast(GeocastMessage.Copy<String> copy) {
      noteOnce(sent(Sent.ALL, copy), copy);
      for (int to = 0; to < size(); to++) {
        if (to != me) {
          net.accept(new Packet(me, to, copy));
        }
      }
    }

    @Override
    public void acknowledge(RobotId to, GeocastMessage.Ack<String> ack) {
      noteOnce(sent(to.name(), ack), ack);
      net.accept(new Packet(me, names().asList().indexOf(to), ack));
    }

    @Override
    public double surelyInsideMm(Region of) {
      return of instanceof Everywhere
          ? Double.POSITIVE_INFINITY
          : of.depthMm(pose().at()) - ERROR_MM;
    }

    @Override
    public void deliver(GeocastId id, String message) {
      deliveries++;
      act(id.origin().robot(), new GeocastFact.deliver(id));
    }

    @Override
    public void dismissed(GeocastId id, Dismissal why) {
      // The specification excuses only robots that do not know their place.
    }
  }

  @Override
  public Node make(int i, Consumer<Packet> net) {
    return new Node(i, net);
  }

  @Override
  public String text(Node node) {
    return node.protocol.state() + node.isDue() + node.nowNs + node.history;
  }

  @Override
  @SuppressWarnings("unchecked") // all messages have this type
  public void receive(Node node, Packet packet) {
    node.receive(SynodRobot.robot(packet.from()), (GeocastMessage<String>) packet.content());
  }

  @Override
  public boolean isSpent(Node recipient, Packet packet) {
    return false; // the histories say which messages there are
  }

  @Override
  public void addSteps(int i, List<Node> all, String none, Steps<Node, String> steps) {
    Node robot = all.get(i);
    if (isCaller(i) && robot.protocol.nextId().number() <= bound("casts")) {
      steps.add(robot.name + " sends", Node::send, none);
    }
    boolean isAhead = all.stream().anyMatch(other -> other.nowNs < robot.nowNs);
    if (!isAhead && !robot.isDue() && robot.nowNs < bound("ticks") * TICK_NS) {
      steps.add(robot.name + "'s clock goes on", node -> node.nowNs += TICK_NS, none);
    }
    if (robot.isDue()) {
      steps.add(robot.name + "'s timer", Node::timer, none);
    }
    if (sum(all, node -> node.moved) < bound("moves")) {
      String where = robot.isInside ? " leaves the area" : " enters the area";
      steps.add(robot.name + where, Node::move, none);
    }
    if (mayRestart(all, node -> node.starts)) {
      steps.add(robot.name + " restarts", Node::restart, none);
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    all.forEach(sender -> check(sender, all, report));
  }

  /**
   * Checks what is about the messages of one robot, on its clock. On it another robot's event may
   * be as late as the skew, but not later than now.
   */
  private static void check(Node sender, List<Node> all, Report report) {
    List<TraceEvent> trace = new ArrayList<>();
    for (Node node : all) {
      node.history.subList(0, BEGUN).forEach(noted -> trace.add(noted.event()));
    }
    addHistory(sender, sender, trace);
    all.stream().filter(node -> node != sender).forEach(node -> addHistory(node, sender, trace));
    trace.sort(Comparator.comparingLong(TraceEvent::timeNs));
    GeocastSpec spec = new GeocastSpec(ERROR_MM, SETTINGS).answering();
    // As if nothing else happened: so all that is required by now is checked.
    trace.add(new Dropped(END_NS, sender.name, "?", "end"));
    for (Monitor monitor : List.of(spec, new GeocastConformance())) {
      trace.forEach(event -> monitor.observe(event, report));
      monitor.finish(END_NS, report);
    }
  }

  private static void addHistory(Node node, Node sender, List<TraceEvent> trace) {
    for (Noted noted : node.history.subList(BEGUN, node.history.size())) {
      if (noted.sender().equals(sender.name) || noted.sender().equals(Fault.WORLD)) {
        TraceEvent event = noted.event();
        long latestNs = Math.min(event.timeNs() + TICK_NS, sender.nowNs);
        trace.add(node == sender ? event : event.at(latestNs));
      }
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> node.deliveries > 0);
  }
}
