package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.exhaustive.Exhaustive;
import org.starl.primitives.exhaustive.Exhaustive.Model;
import org.starl.primitives.exhaustive.Exhaustive.Outcome;
import org.starl.primitives.exhaustive.Exhaustive.Steps;
import org.starl.primitives.exhaustive.Fields;
import org.starl.random.Rng;

/** Exhaustive exploration of the Synod's code, one decree, with writes that a crash loses. */
class SynodExplorationTest {

  private static final int MOST_STATES = 1_000_000;
  private static final Set<?> NO_STATE =
      Set.of(
          "wakeAtNs",
          "resendNs",
          "defeats",
          Rng.class,
          SynodLink.class,
          SynodListener.class,
          SynodTiming.class);

  /**
   * The instance to explore.
   *
   * @param robots of which the first {@code acceptors} vote
   * @param proposers the first robots, which propose a value of their own in each start
   * @param ballots the largest number of ballots of one start beyond its first
   * @param restarts the largest number of crashes, each with a restart
   * @param losesFlushed whether a crash loses even flushed writes, as broken storage does
   */
  private record Shape(
      int robots, int acceptors, int proposers, int ballots, int restarts, boolean losesFlushed) {}

  private record Message(int from, int to, SynodMessage content) {}

  /** A write that a crash loses. */
  private record Write(long version, byte[] record) {}

  private static RobotId robot(int i) {
    return new RobotId("bot" + i);
  }

  /** A robot with its storage, through all of its starts. */
  private static final class Node implements SynodLink, SynodListener {
    final int me;
    final Shape shape;
    final Consumer<Message> net;
    final TreeSet<String> learned = new TreeSet<>();
    final Deque<Write> unflushed = new ArrayDeque<>();
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
      Participants acceptors =
          Participants.of(
              IntStream.range(0, shape.acceptors()).mapToObj(SynodExplorationTest::robot).toList());
      return new Synod(
          robot(me),
          acceptors,
          new ProcessId(robot(me), starts),
          SynodTiming.DEFAULT,
          new Rng(1),
          this,
          this);
    }

    void restart() {
      unflushed.clear();
      stored = shape.losesFlushed() ? null : stored;
      synod = start();
    }

    void flush() {
      Write write = unflushed.remove();
      stored = write.record();
      synod.flushed(write.version());
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
      String before = Fields.text(synod, NO_STATE);
      synod.timer(synod.wakeAtNs());
      ballots += Fields.text(synod, NO_STATE).equals(before) ? 0 : 1;
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
      unflushed.add(new Write(version, record));
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
      unflushed.forEach(write -> text.append(Arrays.toString(write.record())));
      return text.append(hasProposed).append(Fields.text(synod, NO_STATE)).toString();
    }
  }

  /** The shared state is the number of crashes. */
  private record Robots(Shape shape) implements Model<Node, Message, Integer> {

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
    public boolean isDead(Node node) {
      return false;
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

  private static Outcome explore(Shape shape) {
    return new Exhaustive<>(new Robots(shape)).explore(MOST_STATES);
  }

  private static void assertAgrees(Shape shape) {
    Outcome outcome = explore(shape);
    assertThat(outcome.violation()).isEmpty();
    assertThat(outcome.reached()).isPositive();
  }

  @Test
  void aProposerAndACrash() {
    assertAgrees(new Shape(2, 2, 1, 1, 1, false));
  }

  @Test
  void twoProposers() {
    assertAgrees(new Shape(2, 2, 2, 0, 0, false));
  }

  @Test
  void twoProposersWithOneVoterAndACrash() {
    assertAgrees(new Shape(2, 1, 2, 0, 1, false));
  }

  @Test
  void anAcceptorThatForgetsIsFoundWithItsSteps() {
    Outcome outcome = explore(new Shape(2, 1, 2, 0, 1, true));
    assertThat(outcome.violation()).last().asString().startsWith("Agreement");
  }
}
