package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.random.Rng;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;

/**
 * Participants on the worst network of the envelope: any message may be delivered at any time, in
 * any order, again, or never, even after its sender's crash. Any participant may crash, its robot
 * may restart, and any participant may be suspected at any time, rightly or wrongly. Joins,
 * departures and valid confinements append views to a history; each participant learns them late,
 * and may skip some. One seed determines everything.
 */
final class MutexWorld {

  /** The possible errors in the history of views. */
  enum ViewFault {
    NONE,
    LOSES_A_MEMBER,
    READMITS,
    RESTARTS_UNDER_THE_OLD_ID,
    FENCER_GONE
  }

  /**
   * The parameters of a run.
   *
   * @param members the number of members in view 1
   * @param joiners the largest number of later participants: new robots, or restarted ones
   * @param sections the number of sections A, B, ...
   * @param crashes the largest number of crashes
   * @param suspicions the largest number of suspicions
   * @param modes of each section
   */
  record Shape(
      int members,
      int joiners,
      int sections,
      int crashes,
      int suspicions,
      ViewFault fault,
      List<String> modes) {

    /** Without modes. */
    Shape(int members, int joiners, int sections, int crashes, int suspicions, ViewFault fault) {
      this(members, joiners, sections, crashes, suspicions, fault, List.of(""));
    }

    Shape with(ViewFault other) {
      return new Shape(members, joiners, sections, crashes, suspicions, other);
    }

    Shape with(String... some) {
      return new Shape(members, joiners, sections, crashes, suspicions, fault, List.of(some));
    }
  }

  private static final int MOST_IN_FLIGHT = 200;

  final List<MutexNode> nodes = new ArrayList<>();
  final List<MutexMessage> inFlight = new ArrayList<>();
  final List<View> log = new ArrayList<>();
  final List<TraceEvent.Action> trace = new ArrayList<>();
  final Monitors monitors = new Monitors(List.of(new MutexSpec().withModes()));
  long entries;
  long failures;
  long confinements;
  long nowNs;

  private final Shape shape;
  private final MutexNode.Kind kind;
  private final Rng rng;
  private final Set<ProcessId> leaving = new LinkedHashSet<>();
  private final List<ProcessId> out = new ArrayList<>();
  // Counts all changes that an invariant may depend on.
  private long changes;
  private int born;
  private int joinersLeft;
  private int crashesLeft;
  private int suspicionsLeft;

  MutexWorld(Shape shape, MutexNode.Kind kind, long seed) {
    this.shape = shape;
    this.kind = kind;
    this.rng = new Rng(seed);
    joinersLeft = shape.joiners();
    crashesLeft = shape.crashes();
    suspicionsLeft = shape.suspicions();
    List<ProcessId> first = new ArrayList<>();
    for (int i = 0; i < shape.members(); i++) {
      first.add(birth().id);
    }
    log.add(View.closed(first));
    nodes.forEach(node -> node.protocol.learn(log.get(0)));
  }

  /** Takes {@code steps} random steps, or stops at the first violation and returns it. */
  Optional<String> run(int steps) {
    return run(steps, "");
  }

  /** Like {@link #run(int)}, for the invariants whose names begin with {@code lemma}. */
  Optional<String> run(int steps, String lemma) {
    for (int i = 0; i < steps; i++) {
      long before = changes;
      step();
      if (changes > before) {
        Optional<String> violation =
            MutexOracle.violations(nodes, last()).stream()
                .filter(one -> one.startsWith(lemma))
                .findFirst();
        if (violation.isPresent()) {
          return violation;
        }
      }
    }
    return Optional.empty();
  }

  /**
   * Ends all faults: messages arrive within a round of 250 ms, views are decided and learned within
   * a round, holders release, there are no new requests, and all suspicions are right. A request
   * gives up if it waits only for a ghost, or for a dead participant whose sections no remaining
   * participant can know, because all participants that it needed have gone.
   *
   * @return the rounds until no participant waits or holds, or -1 if one does after {@code rounds}
   */
  int heal(int rounds) {
    for (int round = 0; round < rounds; round++) {
      nodes.stream().filter(node -> !node.dead).forEach(node -> node.protocol.learn(last()));
      if (nodes.stream().noneMatch(MutexNode::isActive)) {
        return round;
      }
      nowNs += 250 * NS_PER_MS;
      List<MutexMessage> arriving = new ArrayList<>(inFlight);
      inFlight.clear();
      while (!arriving.isEmpty()) {
        handOver(arriving.remove(rng.nextInt(arriving.size())));
      }
      boolean ghostsMayShrink = confineAll();
      for (MutexNode node : nodes) {
        if (!node.dead) {
          goOn(node, ghostsMayShrink);
        }
      }
    }
    return -1;
  }

  private void goOn(MutexNode node, boolean ghostsMayShrink) {
    node.protocol.timer(nowNs);
    for (MutexNode other : nodes) {
      if (other.dead) {
        node.protocol.suspect(other.id, nowNs);
      }
    }
    if (node.isIn(Phase.CRITICAL)) {
      node.protocol.release(someOf(node.held()));
    } else if (node.isIn(Phase.TRYING) && node.protocol.missing().stream().anyMatch(this::isLost)) {
      node.protocol.withdraw(MutexFailure.DEADLINE);
    } else if (node.isIn(Phase.TRYING)
        && node.protocol.missing().isEmpty()
        && node.protocol.view().number() == last().number()
        && !ghostsMayShrink) {
      node.protocol.withdraw(MutexFailure.OCCUPIED);
    }
  }

  private boolean isLost(ProcessId id) {
    boolean isDead = nodes.stream().anyMatch(node -> node.dead && node.id.equals(id));
    return isDead
        && last().contains(id)
        && nodes.stream()
            .noneMatch(node -> !node.dead && node.protocol.hasSayOver(id, last().admittedBy(id)));
  }

  private void step() {
    nowNs += rng.nextLong(0, 100) * NS_PER_MS;
    int dice = rng.nextInt(100);
    if (dice < 56) {
      deliver();
    } else if (dice < 60) {
      lose();
    } else if (dice < 67) {
      any(node -> !node.dead).ifPresent(node -> node.protocol.timer(nowNs));
    } else if (dice < 79) {
      any(node -> node.isIn(Phase.IDLE) && node.protocol.mayRequest())
          .ifPresent(node -> node.protocol.request(someSections(), nowNs));
    } else if (dice < 84) {
      any(node -> node.isIn(Phase.CRITICAL))
          .ifPresent(node -> node.protocol.release(someOf(node.held())));
    } else if (dice < 86) {
      any(node -> node.isIn(Phase.TRYING))
          .ifPresent(node -> node.protocol.withdraw(MutexFailure.WITHDRAWN));
    } else if (dice < 93) {
      learn();
    } else {
      changeMembers();
    }
  }

  private void deliver() {
    if (inFlight.isEmpty()) {
      return;
    }
    int at = rng.nextInt(inFlight.size());
    MutexMessage message = inFlight.get(at);
    if (!rng.nextBoolean(0.2)) {
      take(at);
    }
    handOver(message);
  }

  void handOver(MutexMessage message) {
    for (MutexNode node : new ArrayList<>(nodes)) {
      if (node.id.equals(message.to()) && !node.dead) {
        node.protocol.receive(message, nowNs);
      }
    }
  }

  private void lose() {
    if (!inFlight.isEmpty()) {
      take(rng.nextInt(inFlight.size()));
    }
  }

  private void send(MutexMessage message) {
    inFlight.add(message);
    if (inFlight.size() > MOST_IN_FLIGHT) {
      lose();
    }
  }

  private void take(int at) {
    int last = inFlight.size() - 1;
    inFlight.set(at, inFlight.get(last));
    inFlight.remove(last);
  }

  private void learn() {
    any(node -> !node.dead)
        .ifPresent(node -> node.protocol.learn(log.get(rng.nextInt(log.size()))));
  }

  // ---------------------------------------------------------------- members

  private void changeMembers() {
    switch (rng.nextInt(9)) {
      case 0 -> join();
      case 1 -> beginLeave();
      case 2 -> leave();
      case 3 -> suspect();
      case 4 -> crash();
      case 5 -> startAnew();
      default -> confine();
    }
    if (shape.fault() == ViewFault.LOSES_A_MEMBER && rng.nextBoolean(0.3)) {
      any(node -> last().contains(node.id))
          .ifPresent(node -> append(last().next().without(node.id)));
    }
    if (shape.fault() == ViewFault.READMITS && !out.isEmpty()) {
      append(last().next().with(out.get(rng.nextInt(out.size()))));
    }
  }

  private void join() {
    if (joinersLeft > 0) {
      joinersLeft--;
      append(last().next().with(birth().id));
    }
  }

  private void beginLeave() {
    if (rng.nextBoolean(0.3)) {
      any(node -> node.isIn(Phase.IDLE) && node.protocol.mayRequest())
          .ifPresent(node -> {
            node.protocol.beginLeave();
            leaving.add(node.id);
          });
    }
    any(node -> node.isDone).ifPresent(node -> leaving.add(node.id));
  }

  private void leave() {
    List<ProcessId> all = new ArrayList<>(leaving);
    if (!all.isEmpty()) {
      append(last().next().without(all.get(rng.nextInt(all.size()))));
    }
  }

  /** Lets a participant suspect one that it waits for, rightly or wrongly. */
  private void suspect() {
    if (suspicionsLeft > 0) {
      any(node -> node.isIn(Phase.TRYING) && !node.protocol.missing().isEmpty())
          .ifPresent(node -> {
            suspicionsLeft--;
            List<ProcessId> silent = List.copyOf(node.protocol.missing());
            node.protocol.suspect(silent.get(rng.nextInt(silent.size())), nowNs);
          });
    }
  }

  private void crash() {
    if (crashesLeft > 0) {
      any(node -> !node.dead).ifPresent(this::crash);
    }
  }

  private void crash(MutexNode node) {
    crashesLeft--;
    node.diesHolding();
    if (shape.fault() == ViewFault.RESTARTS_UNDER_THE_OLD_ID && node.held().isEmpty()) {
      nodes.remove(node);
      MutexNode again = new MutexNode(node.id, kind, this::send, this::trace);
      again.protocol.learn(last());
      nodes.add(again);
    }
  }

  /** Restarts the robot of a dead participant, or lets it declare its place again. */
  private void startAnew() {
    any(node -> node.dead && isLatest(node.id))
        .ifPresent(node -> {
          if (joinersLeft > 0 && shape.fault() != ViewFault.RESTARTS_UNDER_THE_OLD_ID) {
            joinersLeft--;
            append(last().next().with(birth(successor(node.id)).id));
          }
        });
    any(node -> node.dead && !isLatest(node.id) && last().mentions(node.id))
        .ifPresent(node -> {
          node.bodyIn = rng.nextBoolean(0.5) ? Sections.NONE : someOf(node.bodyIn);
          trace(new MutexFact.StandsIn(successor(node.id), node.bodyIn));
          append(last().next().confined(node.id, node.bodyIn));
        });
  }

  private boolean isLatest(ProcessId id) {
    return nodes.stream()
        .noneMatch(other -> other.id.robot().equals(id.robot()) && other.id.compareTo(id) > 0);
  }

  private static ProcessId successor(ProcessId id) {
    return new ProcessId(id.robot(), id.inc() + (1L << Integer.SIZE));
  }

  private void confine() {
    List<Confinement> all = new ArrayList<>();
    nodes.forEach(node -> all.addAll(node.proposed));
    if (!all.isEmpty()) {
      confine(all.get(rng.nextInt(all.size())));
    }
  }

  /** Applies all proposals; returns whether a view changed, or more proposals may come. */
  private boolean confineAll() {
    boolean any = inFlight.stream().anyMatch(message -> !(message instanceof MutexMessage.Req));
    for (MutexNode node : nodes) {
      for (Confinement each : List.copyOf(node.proposed)) {
        any |= confine(each);
      }
      node.proposed.clear();
    }
    return any;
  }

  /** The rule of confinement: every fencer is listed, before and after. */
  private boolean confine(Confinement confinement) {
    boolean counts = confinement.hasFencersIn(last()) || shape.fault() == ViewFault.FENCER_GONE;
    if (!counts || !confinement.changes(last())) {
      return false;
    }
    confinements++;
    append(confinement.applyTo(last().next()));
    return true;
  }

  private View last() {
    return log.get(log.size() - 1);
  }

  private void append(View next) {
    for (ProcessId id : last().ids()) {
      if (!next.contains(id)) {
        out.add(id);
      }
    }
    log.add(next);
    changes++;
  }

  private MutexNode birth() {
    born++;
    return birth(ProcessId.first(new RobotId("p" + born), 1));
  }

  private MutexNode birth(ProcessId id) {
    MutexNode node = new MutexNode(id, kind, this::send, this::trace);
    // The order of names is not the order of joins, so a joiner may win a tie.
    nodes.add(rng.nextInt(nodes.size() + 1), node);
    return node;
  }

  private void trace(MutexFact event) {
    changes++;
    entries += event instanceof MutexFact.OdMutex ? 1 : 0;
    failures += event instanceof MutexFact.Withdraw ? 1 : 0;
    TraceEvent.Action action =
        TraceEvent.Action.of(
            nowNs, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event);
    trace.add(action);
    monitors.observe(action);
  }

  private Optional<MutexNode> any(Predicate<MutexNode> such) {
    List<MutexNode> all = nodes.stream().filter(such).toList();
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(rng.nextInt(all.size())));
  }

  private TreeSet<String> someSections() {
    TreeSet<String> all = new TreeSet<>();
    for (int i = 0; i < shape.sections(); i++) {
      List<String> modes = shape.modes();
      String mode = modes.size() == 1 ? modes.get(0) : modes.get(rng.nextInt(modes.size()));
      all.add((char) ('A' + i) + mode);
    }
    return someOf(all);
  }

  private TreeSet<String> someOf(Collection<String> names) {
    TreeSet<String> some = new TreeSet<>();
    SortedSet<String> all = new TreeSet<>(names);
    for (String name : all) {
      if (rng.nextBoolean(0.5)) {
        some.add(name);
      }
    }
    if (some.isEmpty() && !all.isEmpty()) {
      List<String> list = List.copyOf(all);
      some.add(list.get(rng.nextInt(list.size())));
    }
    return some;
  }
}
