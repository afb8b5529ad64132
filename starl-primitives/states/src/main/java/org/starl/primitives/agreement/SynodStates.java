package org.starl.primitives.agreement;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Model;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.random.Rng;

/** The states of robots that run the Synod's code for one decree, with writes that a crash loses. */
public final class SynodStates implements Model<SynodStates.Node, SynodStates.Message, Integer> {

  private static final int MOST_ROBOTS = 5;

  /**
   * Robots decide one value; a crash loses what is not flushed, and the robot starts again.
   */
  public static final StateSpace SPACE =
      new StateSpace(
          "agreement",
          "a robot knows the decision",
          List.of(
              new Bound("robots", "robots", 1, 2, MOST_ROBOTS),
              new Bound("crashes", "crashes, each with a restart", 0, 0, MOST_ROBOTS),
              new Bound("voters", "robots that vote; 0: all", 0, 0, MOST_ROBOTS),
              new Bound("proposers", "robots that propose", 1, 1, MOST_ROBOTS),
              new Bound("ballots", "further ballots of one start of a robot", 0, 0, 3)),
          SynodStates::search);

  private static StateSearch<?, ?, ?> search(ToIntFunction<String> bounds) {
    int robots = bounds.applyAsInt("robots");
    int voters = bounds.applyAsInt("voters");
    Shape shape =
        new Shape(
            robots,
            voters == 0 ? robots : Math.min(robots, voters),
            Math.min(robots, bounds.applyAsInt("proposers")),
            bounds.applyAsInt("ballots"),
            bounds.applyAsInt("crashes"),
            false);
    return new StateSearch<>(new SynodStates(shape));
  }

  /**
   * The instance to explore.
   *
   * @param robots of which the first {@code acceptors} vote
   * @param proposers the first robots, which propose a value of their own in each start
   * @param ballots the largest number of ballots of one start beyond its first
   * @param restarts the largest number of crashes, each with a restart
   * @param losesFlushed whether a crash loses even flushed writes, as broken storage does
   */
  record Shape(
      int robots, int acceptors, int proposers, int ballots, int restarts, boolean losesFlushed) {}

  record Message(int from, int to, SynodMessage content) {}

  private static RobotId robot(int i) {
    return new RobotId("bot" + i);
  }

  /** A robot with its storage, through all of its starts. */
  static final class Node implements SynodLink, SynodListener {
    final int me;
    final Shape shape;
    final Consumer<Message> net;
    final TreeSet<String> learned = new TreeSet<>();
    // Writes that a crash loses, and the version of the last one that it does not lose.
    final Deque<byte[]> unflushed = new ArrayDeque<>();
    long flushedVersion;
    byte @Nullable [] stored;
    int starts;
    int ballots;
    boolean hasProposed;
    Synod synod;

    Node(int me, Shape shape, Consumer<Message> net) {
      this.me = me;
      this.shape = shape;
      this.net = net;
      this.synod = start();
    }

    private Synod start() {
      starts++;
      ballots = 0;
      hasProposed = false;
      List<RobotId> voters = new ArrayList<>();
      for (int i = 0; i < shape.acceptors(); i++) {
        voters.add(robot(i));
      }
      return new Synod(
          robot(me),
          Participants.of(voters),
          ProcessId.first(robot(me), starts),
          SynodTiming.DEFAULT,
          new Rng(1),
          this,
          this);
    }

    void restart() {
      unflushed.clear();
      flushedVersion = 0;
      stored = shape.losesFlushed() ? null : stored;
      synod = start();
    }

    void flush() {
      stored = unflushed.remove();
      flushedVersion++;
      synod.flushed(flushedVersion);
    }

    /** Only a crash shows when a write is flushed. */
    void flushIfNothingIsLost() {
      while (!unflushed.isEmpty() && (shape.restarts() == 0 || shape.losesFlushed())) {
        flush();
      }
    }

    void propose() {
      hasProposed = true;
      Value mine = Value.of(new byte[] {(byte) me});
      synod.propose(1, Value.EMPTY, wishes -> mine, 0);
      flushIfNothingIsLost();
    }

    /** The proposer's timer is due; counted if that is more than a repetition. */
    void timer() {
      String before = synod.state();
      synod.timer(synod.wakeAtNs());
      ballots += synod.state().equals(before) ? 0 : 1;
    }

    @Override
    public byte @Nullable [] record() {
      return stored;
    }

    @Override
    public void send(RobotId to, SynodMessage message) {
      net.accept(new Message(me, Integer.parseInt(to.name().substring(3)), message));
    }

    @Override
    public void persist(long version, byte[] record) {
      unflushed.add(record);
    }

    @Override
    public void chosen(long number, Value value) {
      learned.add(value.toString());
    }

    @Override
    public void learned(long number, Value value) {
      learned.add(value.toString());
    }

    @Override
    public String toString() {
      StringBuilder text = new StringBuilder();
      text.append(learned).append(Arrays.toString(stored)).append(starts).append(ballots);
      unflushed.forEach(write -> text.append(Arrays.toString(write)));
      return text.append(hasProposed).append(synod.state()).toString();
    }
  }

  private final Shape shape;

  /** The state outside the robots is the number of crashes. */
  SynodStates(Shape shape) {
    this.shape = shape;
  }

  @Override
  public int size() {
    return shape.robots();
  }

  @Override
  public Node make(int i, Consumer<Message> net) {
    return new Node(i, shape, net);
  }

  @Override
  public String text(Node node) {
    return node.toString();
  }

  @Override
  public int to(Message message) {
    return message.to();
  }

  @Override
  public void receive(Node node, Message message) {
    node.synod.received(robot(message.from()), message.content(), 0);
    node.flushIfNothingIsLost();
  }

  @Override
  public boolean isSpent(Node recipient, Message message) {
    return recipient.synod.isSpent(message.content());
  }

  @Override
  public Integer begin() {
    return 0;
  }

  @Override
  public void addSteps(int i, Node node, Integer crashes, Steps<Node, Integer> steps) {
    if (i < shape.proposers() && !node.hasProposed && node.synod.latest() == null) {
      steps.add(robot(i) + " proposes", Node::propose, crashes);
    }
    if (node.synod.isProposing() && node.ballots < shape.ballots()) {
      steps.add(robot(i) + "'s timer", Node::timer, crashes);
    }
    if (!node.unflushed.isEmpty()) {
      steps.add(robot(i) + " flushes", Node::flush, crashes);
    }
    if (crashes < shape.restarts()) {
      steps.add(robot(i) + " restarts", Node::restart, crashes + 1);
    }
  }

  @Override
  public Optional<String> violation(List<Node> nodes, Integer crashes) {
    TreeSet<String> decided = new TreeSet<>();
    nodes.forEach(node -> decided.addAll(node.learned));
    return decided.size() > 1 ? Optional.of("Agreement: " + decided) : Optional.empty();
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> !node.learned.isEmpty());
  }
}
