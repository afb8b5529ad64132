package org.starl.primitives.paths;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.RobotModel;
import org.starl.primitives.agreement.SynodRobot;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/**
 * The states of robots that claim reach tubes: each drives from its place to one in the middle that
 * all want, and back. Repetitions make no other state, since a message stays for ever.
 */
public class TubeStates extends RobotModel<TubeStates.Node> {

  /** Robots claim, drive, give back, withdraw, crash and start again. */
  public static final StateSpace SPACE =
      new StateSpace(
          "paths",
          "a robot is in the middle",
          List.of(
              new Bound("robots", "robots, all vote", 2, 2, 4),
              new Bound("crashes", "crashes, each with a restart", 0, 0, 4),
              new Bound("callers", "robots that drive; 0: all", 0, 0, 4),
              new Bound("placed", "1: all know at the start where each stands", 0, 0, 1),
              new Bound("requests", "tubes that a robot requests", 1, 1, 3),
              new Bound("withdrawals", "requests that are withdrawn", 0, 0, 3)),
          bounds -> new StateSearch<>(new TubeStates(bounds)));

  private static final Instance SOURCE = Instance.of(TubeFact.PRIMITIVE, "states");
  private static final int RADIUS_MM = 240;
  private static final int BODY_MM = 165;
  private static final Point MIDDLE = new Point(1_000, 1_500);

  private final int crashes;
  private final boolean placed;
  private final int requests;
  private final int withdrawals;

  TubeStates(ToIntFunction<String> bounds) {
    super(bounds);
    crashes = bound("crashes");
    placed = bound("placed") == 1;
    requests = bound("requests");
    withdrawals = bound("withdrawals");
  }

  /** What a robot reads from its storage when it starts; another answer in a test. */
  Optional<TubeVoter.Note> read(String key, TubeVoter.@Nullable Note note) {
    return Optional.ofNullable(note);
  }

  /** A write that a crash loses, and what happens when it does not. */
  private record Write(String key, TubeVoter.Note note, Runnable whenFlushed) {}

  /** A robot, through all starts of its program. */
  final class Node implements TubeClaims.Port, TubeClaims.Listener {
    private final int me;
    private final RobotId name;
    private final Consumer<Packet> net;
    private final TreeMap<String, TubeVoter.Note> stable = new TreeMap<>();
    private final Deque<Write> unflushed = new ArrayDeque<>();
    private int boot;
    private int asked;
    private int withdrawn;
    private Tube body;
    private @Nullable Tube entering;
    private List<Tube> shown = List.of();
    private TubeClaims claims;

    Node(int me, Consumer<Packet> net) {
      this.me = me;
      this.net = net;
      name = SynodRobot.robot(me);
      body = start(me);
      if (placed) {
        stable.put(TubeClaims.OWN, note(me));
        for (int i = 0; i < size(); i++) {
          stable.put(TubeClaims.note(SynodRobot.robot(i)), note(i));
        }
      }
      claims = start();
    }

    private static TubeVoter.Note note(int robot) {
      return new TubeVoter.Note(new Holding(1, List.of(start(robot)), List.of()), true);
    }

    private static Tube start(int robot) {
      return Tube.disc(new Point(2_000.0 * robot, 0), RADIUS_MM);
    }

    private TubeClaims start() {
      boot++;
      TubeClaims program =
          new TubeClaims(name, boot, names(), TubeSettings.DEFAULT, RADIUS_MM, this, this);
      shown = program.held();
      return program;
    }

    private void restart() {
      unflushed.clear();
      entering = null;
      claims = start();
      claims.begin();
    }

    private void step(Consumer<Node> action) {
      action.accept(this);
      while (crashes == 0 && !unflushed.isEmpty()) {
        flush();
      }
    }

    private void flush() {
      Write write = unflushed.remove();
      stable.put(write.key(), write.note());
      write.whenFlushed().run();
    }

    private void drive() {
      if (body.points().size() > 1) {
        body = Tube.disc(body.end(), RADIUS_MM);
      } else if (entering != null) {
        body = entering;
        entering = null;
      }
      claims.keep(List.of(body));
    }

    private void ask() {
      asked++;
      Point from = body.end();
      claims.ask(
          new Tube(List.of(from, from.equals(MIDDLE) ? start(me).end() : MIDDLE), RADIUS_MM));
    }

    private void withdraw() {
      withdrawn++;
      claims.withdraw();
    }

    private void giveBack() {
      entering = null;
      claims.keep(List.of(body));
    }

    /** Whether it holds what its body does not need, or would need less if it drove on. */
    private boolean mayDrive() {
      return claims.isSettled() && (entering != null || !claims.held().equals(List.of(disc())));
    }

    private Tube disc() {
      return Tube.disc(body.end(), RADIUS_MM);
    }

    @Override
    public long nowNs() {
      return 0;
    }

    @Override
    public Point at() {
      return body.end();
    }

    @Override
    public Optional<TubeVoter.Note> stored(String key) {
      return read(key, stable.get(key));
    }

    @Override
    public void store(String key, TubeVoter.Note note, Runnable whenFlushed) {
      List<Write> same = unflushed.stream().filter(each -> each.key().equals(key)).toList();
      boolean isLatest =
          same.isEmpty() ? note.equals(stable.get(key)) : same.getLast().note().equals(note);
      // A consent that is said again: it is on its way, or was already sent.
      if (!note.voted() || !isLatest) {
        unflushed.add(new Write(key, note, whenFlushed));
      }
    }

    @Override
    public void send(RobotId to, TubeMessage message) {
      net.accept(new Packet(me, SynodRobot.number(to), message));
    }

    @Override
    public void holds(TubeList tubes) {
      shown = tubes.tubes();
    }

    @Override
    public void wakeAt(long timeNs) {
      // Only repetitions.
    }

    @Override
    public void granted(Tube tube) {
      entering = tube;
    }

    @Override
    public void refused() {
      // The next request is a step of its own.
    }

    @Override
    public void settled() {
      // Asks whenever it may.
    }
  }

  @Override
  public Node make(int i, Consumer<Packet> net) {
    return new Node(i, net);
  }

  @Override
  public String text(Node node) {
    StringBuilder text = new StringBuilder();
    node.unflushed.forEach(write -> text.append(write.key()).append(write.note()));
    return text.append(crashes == 0 ? "" : node.stable)
        .append(node.boot)
        .append(node.asked)
        .append(node.withdrawn)
        .append(node.body)
        .append(node.entering)
        .append(node.shown)
        .append(node.claims.state())
        .toString();
  }

  @Override
  public void receive(Node node, Packet packet) {
    RobotId from = SynodRobot.robot(packet.from());
    node.step(robot -> robot.claims.received(from, (TubeMessage) packet.content()));
  }

  @Override
  public boolean isSpent(Node recipient, Packet packet) {
    RobotId from = SynodRobot.robot(packet.from());
    TubeMessage message = (TubeMessage) packet.content();
    TubeVoter.Note kept = recipient.stable.get(TubeClaims.note(from));
    boolean mayForget =
        message instanceof TubeMessage.Ask
            && crashes > 0
            && (kept == null || kept.holding().version() <= message.version());
    return !mayForget && recipient.claims.isSpent(from, message);
  }

  @Override
  public void addSteps(int i, List<Node> all, String none, Steps<Node, String> steps) {
    Node robot = all.get(i);
    TubeClaims claims = robot.claims;
    if (!claims.isPlaced()) {
      steps.add(robot.name + " has a fix", node -> node.step(it -> it.claims.place()), none);
    } else if (robot.mayDrive()) {
      steps.add(robot.name + " drives on", node -> node.step(Node::drive), none);
    } else if (claims.isSettled() && robot.asked < requests && isCaller(i)) {
      steps.add(robot.name + " requests a tube", node -> node.step(Node::ask), none);
    }
    if (robot.entering != null && claims.isSettled()) {
      steps.add(robot.name + " gives its tube back", node -> node.step(Node::giveBack), none);
    }
    if (claims.isAsking() && sum(all, node -> node.withdrawn) < withdrawals) {
      steps.add(robot.name + " withdraws", node -> node.step(Node::withdraw), none);
    }
    if (!robot.unflushed.isEmpty()) {
      steps.add(robot.name + " flushes", Node::flush, none);
    }
    if (mayRestart(all, node -> node.boot)) {
      steps.add(robot.name + " restarts", Node::restart, none);
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    TubesSpec spec = new TubesSpec();
    for (Node node : all) {
      TubeList held = new TubeList(node.shown);
      spec.observe(new Variable(0, node.name, SOURCE, TubeFact.HELD, held), report);
      checkBody(node, all, report);
    }
  }

  /** Its body is in what it holds; before it holds anything, in nothing that another one holds. */
  private static void checkBody(Node node, List<Node> all, Report report) {
    boolean isInside = node.shown.isEmpty();
    for (Tube held : node.shown) {
      isInside |= held.equals(node.body) || held.containsDisc(node.body.end(), BODY_MM);
    }
    if (!isInside) {
      String detail = node.name + " is in " + node.body + ", and holds " + Tube.text(node.shown);
      report.violated(TubesSpec.INSIDE, 0, List.of(node.name), detail);
    }
    List<Tube> body = List.of(new Tube(node.body.points(), BODY_MM));
    for (Node other : all) {
      if (other != node && Tube.meet(body, other.shown)) {
        String detail =
            other.name + " holds " + Tube.text(other.shown) + ", " + node.name + " is there";
        report.violated(TubesSpec.TUBES, 0, List.of(node.name, other.name), detail);
      }
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> node.body.end().equals(MIDDLE));
  }
}
