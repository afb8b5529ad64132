package org.starl.primitives.agreement;

import java.util.List;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.random.Rng;
import org.starl.spec.Monitor.Report;

/** The states of robots that run the Synod's code for one decree. */
public final class SynodStates extends SynodModel<SynodStates.Node> {

  /** Robots decide one value; those that call propose one of their own in each start. */
  public static final StateSpace SPACE =
      space(
          "agreement",
          "a robot knows the decision",
          bounds -> new SynodStates(bounds, false),
          new Bound("voters", "robots that vote; 0: all", 0, 0, 5));

  private final int voters;
  private final boolean losesFlushed;

  /**
   * @param losesFlushed whether a crash loses even flushed writes, as broken storage does
   */
  SynodStates(ToIntFunction<String> bounds, boolean losesFlushed) {
    super(bounds);
    voters = bounds.applyAsInt("voters");
    this.losesFlushed = losesFlushed;
  }

  /** A robot with the values that it has learned. */
  final class Node extends SynodRobot<Node.Protocol> {
    private final TreeSet<String> learned = new TreeSet<>();
    private boolean hasProposed;

    Node(int me, Consumer<Packet> net) {
      super(me, net, mayCrash() && !losesFlushed);
    }

    @Override
    protected Protocol begin(ProcessId id) {
      hasProposed = false;
      return new Protocol(id, nowNs);
    }

    private void propose() {
      hasProposed = true;
      Value mine = Value.of(new byte[] {(byte) me});
      protocol().synod.propose(1, Value.EMPTY, wishes -> mine, nowNs);
    }

    @Override
    public byte @Nullable [] record() {
      return losesFlushed ? null : super.record();
    }

    @Override
    protected String state() {
      return learned + " " + hasProposed;
    }

    final class Protocol extends SynodProtocol {
      Protocol(ProcessId id, long now) {
        super(id.robot(), acceptors(), id, SynodTiming.DEFAULT, new Rng(1), Node.this, now);
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
      protected void ownTimers() {
        // It has none.
      }

      @Override
      protected long ownWakeAtNs() {
        return NEVER;
      }
    }
  }

  private Participants acceptors() {
    int most = Math.min(size(), voters == 0 ? size() : voters);
    return Participants.of(names().asList().subList(0, most));
  }

  @Override
  protected Node create(int i, Consumer<Packet> net) {
    return new Node(i, net);
  }

  @Override
  protected void addCalls(Node robot, BiConsumer<String, Consumer<Node>> calls) {
    boolean isOpen = robot.protocol().synod.latest() == null;
    if (!robot.hasProposed && isOpen) {
      calls.accept("proposes", Node::propose);
    }
  }

  @Override
  protected void check(List<Node> all, Report report) {
    TreeSet<String> decided = new TreeSet<>();
    all.forEach(node -> decided.addAll(node.learned));
    if (decided.size() > 1) {
      report.violated("Agreement", 0, List.of(), decided.toString());
    }
  }

  @Override
  public boolean isReached(List<Node> nodes) {
    return nodes.stream().anyMatch(node -> !node.learned.isEmpty());
  }
}
