package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Model;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;

/**
 * The states of a mutex's participants. A repeated request is in the set of messages
 * already, an expired one is a withdrawal, a silent participant is suspected. Any confinement whose
 * fencers are in the last view may become the next view.
 */
public final class MutexStates implements Model<MutexNode, MutexMessage, MutexStates.World> {

  private static final int MOST_ROBOTS = 4;

  /** One section, in one of two modes, of which the second may have a capacity. */
  static final List<List<List<String>>> MODES =
      List.of(List.of(List.of("A/e"), List.of("A/w")), List.of(List.of("A/e"), List.of("A/w*2")));

  static final List<List<String>> SEQUENCES = List.of(List.of("A", "B"), List.of("B", "A"));

  /** Members of one view request sections, enter, and release them one by one. */
  public static final StateSpace SPACE =
      new StateSpace(
          "mutex",
          "a member is in its sections",
          List.of(
              new Bound("robots", "members", 1, 2, MOST_ROBOTS),
              new Bound("crashes", "members that crash for ever", 0, 0, MOST_ROBOTS),
              new Bound("requesters", "members that request; 0: all", 0, 0, MOST_ROBOTS),
              new Bound("modes", "1: in one of two modes; 2: of which one has 2 places", 0, 0, 2),
              new Bound("requests", "requests of one member", 1, 1, 3),
              new Bound("sections", "1: of one section; 2: of one, or of two", 1, 1, 2),
              new Bound("sequences", "1: of two sections, one by one, in both orders", 0, 0, 1),
              new Bound("withdrawals", "1: a member may withdraw its request", 0, 0, 1),
              new Bound("suspicions", "wrong or right suspicions", 0, 0, MOST_ROBOTS)),
          MutexStates::search);

  /**
   * The instance to explore.
   *
   * @param views the initial views; the members of the first one know it, and participants of a
   *     later one learn that view first. Confinements add views
   * @param wants the sets of sections that may be requested, or the sequences
   * @param inOrder whether they are sequences
   * @param requests the largest number of requests by one participant
   * @param requesters the first participants, which request; the others only answer
   * @param suspicions the largest number of suspicions
   * @param crashes the largest number of participants that crash and do not come back; their robots
   *     stay in the sections that they hold
   */
  record Shape(
      List<View> views,
      List<List<String>> wants,
      boolean inOrder,
      int requests,
      int requesters,
      boolean withdrawals,
      int suspicions,
      int crashes) {

    /** Of sets. */
    Shape(
        List<View> views,
        List<List<String>> wants,
        int requests,
        int requesters,
        boolean withdrawals,
        int suspicions,
        int crashes) {
      this(views, wants, false, requests, requesters, withdrawals, suspicions, crashes);
    }

    /** All participants request, and none crashes. */
    Shape(
        List<View> views,
        List<List<String>> wants,
        int requests,
        boolean withdrawals,
        int suspicions) {
      this(views, wants, requests, Integer.MAX_VALUE, withdrawals, suspicions, 0);
    }
  }

  /** The views so far, and how often what is limited has happened. */
  record World(List<View> views, int suspicions, int crashes) {

    View last() {
      return views.get(views.size() - 1);
    }

    World with(View next) {
      List<View> longer = new ArrayList<>(views);
      longer.add(next);
      return new World(longer, suspicions, crashes);
    }
  }

  private final Shape shape;
  private final MutexNode.Kind kind;
  private final List<ProcessId> ids;

  MutexStates(Shape shape, MutexNode.Kind kind) {
    this.shape = shape;
    this.kind = kind;
    this.ids = begin().last().ids();
  }

  private static StateSearch<?, ?, ?> search(ToIntFunction<String> bounds) {
    List<ProcessId> members = new ArrayList<>();
    for (int i = 0; i < bounds.applyAsInt("robots"); i++) {
      members.add(ProcessId.first(new RobotId("bot" + i), 1));
    }
    int requesters = bounds.applyAsInt("requesters");
    boolean inOrder = bounds.applyAsInt("sequences") == 1;
    List<List<String>> sets =
        List.of(List.of("A"), List.of("A", "B")).subList(0, bounds.applyAsInt("sections"));
    int modes = bounds.applyAsInt("modes");
    Shape shape =
        new Shape(
            List.of(View.closed(members)),
            inOrder ? SEQUENCES : modes > 0 ? MODES.get(modes - 1) : sets,
            inOrder,
            bounds.applyAsInt("requests"),
            requesters == 0 ? members.size() : requesters,
            bounds.applyAsInt("withdrawals") == 1,
            bounds.applyAsInt("suspicions"),
            bounds.applyAsInt("crashes"));
    return new StateSearch<>(new MutexStates(shape, MutexProtocol::new));
  }

  @Override
  public int size() {
    return ids.size();
  }

  @Override
  public MutexNode make(int i, Consumer<MutexMessage> net) {
    MutexNode node = new MutexNode(ids.get(i), kind, net, e -> {});
    View known = shape.views().get(0);
    if (known.contains(node.id)) {
      node.protocol.learn(known);
    }
    return node;
  }

  @Override
  public String text(MutexNode node) {
    TreeSet<String> proposed = new TreeSet<>();
    node.proposed.forEach(each -> proposed.add(each.toString()));
    return (node.dead ? "dead in " + node.bodyIn : "")
        + List.of(node.protocol.state(), node.held(), node.num, node.ts, node.want)
        + node.consentedTo
        + proposed
        + node.protocol.view();
  }

  @Override
  public int to(MutexMessage message) {
    return ids.indexOf(message.to());
  }

  @Override
  public void receive(MutexNode node, MutexMessage message) {
    node.protocol.receive(message, 0);
  }

  @Override
  public boolean isSpent(MutexNode recipient, MutexMessage message) {
    return recipient.dead;
  }

  @Override
  public World begin() {
    return new World(shape.views(), 0, 0);
  }

  @Override
  public Optional<String> violation(List<MutexNode> nodes, World world) {
    return MutexOracle.violations(nodes, world.last()).stream().findFirst();
  }

  @Override
  public boolean isReached(List<MutexNode> nodes) {
    return nodes.stream().anyMatch(node -> node.isIn(Phase.CRITICAL));
  }

  @Override
  public void addSteps(int i, List<MutexNode> nodes, World world, Steps<MutexNode, World> steps) {
    MutexNode node = nodes.get(i);
    if (node.dead) {
      return;
    }
    boolean mayRequest = i < shape.requesters() && node.num < shape.requests();
    if (mayRequest && node.isIn(Phase.IDLE) && node.protocol.mayRequest()) {
      for (List<String> want : shape.wants()) {
        steps.add(
            node.id + " requests " + want,
            n -> n.protocol.request(want, shape.inOrder(), 0),
            world);
      }
    }
    if (node.isIn(Phase.TRYING) && shape.withdrawals()) {
      steps.add(node.id + " withdraws", n -> n.protocol.withdraw(MutexFailure.WITHDRAWN), world);
    }
    // Who waits stays in one section.
    if (node.isIn(Phase.CRITICAL) || node.held().size() > 1) {
      for (String section : node.protocol.held()) {
        steps.add(
            node.id + " releases " + section,
            n -> n.protocol.release(new TreeSet<>(List.of(section))),
            world);
      }
    }
    addFailures(node, world, steps);
    addViews(node, world, steps);
  }

  private void addFailures(MutexNode node, World world, Steps<MutexNode, World> steps) {
    if (node.isIn(Phase.TRYING) && world.suspicions() < shape.suspicions()) {
      World after = new World(world.views(), world.suspicions() + 1, world.crashes());
      for (ProcessId other : node.protocol.missing()) {
        steps.add(node.id + " suspects " + other, n -> n.protocol.suspect(other, 0), after);
      }
    }
    if (world.crashes() < shape.crashes()) {
      World after = new World(world.views(), world.suspicions(), world.crashes() + 1);
      steps.add(node.id + " crashes", MutexNode::diesHolding, after);
    }
  }

  private void addViews(MutexNode node, World world, Steps<MutexNode, World> steps) {
    View last = world.last();
    for (Confinement each : node.proposed) {
      if (each.changes(last) && each.hasFencersIn(last)) {
        steps.add(each + " is decided", n -> {}, world.with(each.applyTo(last.next())));
      }
    }
    for (View view : world.views()) {
      View learned = node.protocol.view();
      boolean isOut = learned.equals(View.NONE) && !view.contains(node.id);
      if (view.number() > learned.number() && !isOut) {
        steps.add(node.id + " learns view " + view, n -> n.protocol.learn(view), world);
      }
    }
  }
}
