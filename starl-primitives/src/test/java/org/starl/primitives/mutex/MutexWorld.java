package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.ProcessId;
import org.starl.RobotId;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.random.Rng;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;

/**
 * Participants over a network that is as bad as the envelope allows: any message may be delivered at
 * any time, in any order, again, or never, also after its sender died. Views are a history to which
 * joins, departures and (valid) exclusions are appended; each participant learns of them late, and
 * may skip some. Everything follows from one seed.
 */
final class MutexWorld {

  /** How the history of views may be wrong. */
  enum ViewFault {
    NONE,
    LOSES_A_MEMBER,
    READMITS,
    RESTARTS_UNDER_THE_OLD_ID
  }

  /**
   * What a run is made of.
   *
   * @param members in view 1
   * @param joiners who may come later, at most
   * @param sections A, B, ...
   * @param crashes how many may die, at most
   * @param exclusions how many may be put out although they are up, at most
   */
  record Shape(
      int members, int joiners, int sections, int crashes, int exclusions, ViewFault fault) {}

  private static final int MOST_IN_FLIGHT = 200;
  private static final long NS_PER_MS = 1_000_000;

  final List<MutexNode> nodes = new ArrayList<>();
  final List<MutexMessage> inFlight = new ArrayList<>();
  final List<View> log = new ArrayList<>();
  final Monitors monitors = new Monitors(List.of(new MutexSpec("x")));
  long entries;
  long failures;
  long nowNs;

  private final Shape shape;
  private final MutexNode.Kind kind;
  private final Rng rng;
  private final List<ProcessId> leaving = new ArrayList<>();
  private final List<ProcessId> out = new ArrayList<>();
  // Pairs (fencer, excluded): the first never grants the second anything again.
  private final Set<List<ProcessId>> fences = new LinkedHashSet<>();
  // Counts whatever an invariant may depend on.
  private long changes;
  private int born;
  private int joinersLeft;
  private int crashesLeft;
  private int exclusionsLeft;

  MutexWorld(Shape shape, MutexNode.Kind kind, long seed) {
    this.shape = shape;
    this.kind = kind;
    this.rng = new Rng(seed);
    joinersLeft = shape.joiners();
    crashesLeft = shape.crashes();
    exclusionsLeft = shape.exclusions();
    List<ProcessId> first = new ArrayList<>();
    for (int i = 0; i < shape.members(); i++) {
      first.add(birth().id);
    }
    log.add(View.closed(first));
    nodes.forEach(node -> node.protocol.learn(log.get(0)));
  }

  /** Takes {@code steps} random steps, or stops where any invariant is violated and tells it. */
  Optional<String> run(int steps) {
    return run(steps, "");
  }

  /** The same, for the invariants whose names begin with {@code lemma}. */
  Optional<String> run(int steps, String lemma) {
    for (int i = 0; i < steps; i++) {
      long before = changes;
      step();
      if (changes > before) {
        Optional<String> violation = MutexOracle.violation(lemma, nodes, last());
        if (violation.isPresent()) {
          return violation;
        }
      }
    }
    return Optional.empty();
  }

  /**
   * From now on all messages arrive within a round of 250 ms, everybody has learned the last view,
   * holders release, and nobody asks for more.
   *
   * @return the rounds until nobody waits or holds, or -1 if that is not so after {@code rounds}
   */
  int heal(int rounds) {
    nodes.forEach(node -> node.protocol.learn(last()));
    for (int round = 0; round < rounds; round++) {
      if (nodes.stream().noneMatch(MutexNode::isActive)) {
        return round;
      }
      nowNs += 250 * NS_PER_MS;
      List<MutexMessage> arriving = new ArrayList<>(inFlight);
      inFlight.clear();
      while (!arriving.isEmpty()) {
        handOver(arriving.remove(rng.nextInt(arriving.size())));
      }
      for (MutexNode node : nodes) {
        node.protocol.timer(nowNs);
        if (node.isIn(Phase.CRITICAL)) {
          node.protocol.release(someOf(node.protocol.held()));
        }
      }
    }
    return -1;
  }

  private void step() {
    nowNs += rng.nextLong(0, 100) * NS_PER_MS;
    int dice = rng.nextInt(100);
    if (dice < 58) {
      deliver();
    } else if (dice < 62) {
      lose();
    } else if (dice < 68) {
      any(node -> !node.dead).ifPresent(node -> node.protocol.timer(nowNs));
    } else if (dice < 80) {
      any(node -> node.isIn(Phase.IDLE) && node.protocol.mayRequest())
          .ifPresent(node -> node.protocol.request(someSections(), nowNs));
    } else if (dice < 86) {
      any(node -> node.isIn(Phase.CRITICAL))
          .ifPresent(node -> node.protocol.release(someOf(node.protocol.held())));
    } else if (dice < 88) {
      any(node -> node.isIn(Phase.TRYING))
          .ifPresent(node -> node.protocol.withdraw(MutexFailure.WITHDRAWN));
    } else if (dice < 95) {
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
    for (MutexNode node : nodes) {
      if (node.id.equals(message.to()) && !node.dead && !isFenced(node.id, message)) {
        node.protocol.receive(message);
      }
    }
  }

  private boolean isFenced(ProcessId by, MutexMessage message) {
    return message instanceof MutexMessage.Req && fences.contains(List.of(by, message.from()));
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

  private void changeMembers() {
    switch (rng.nextInt(6)) {
      case 0 -> join();
      case 1 -> beginLeave();
      case 2, 3 -> leave();
      case 4 -> exclude();
      default -> crash();
    }
    if (shape.fault() == ViewFault.LOSES_A_MEMBER && rng.nextBoolean(0.3)) {
      any(node -> last().contains(node.id)).ifPresent(node -> append(node.id, false));
    }
    if (shape.fault() == ViewFault.READMITS && !out.isEmpty()) {
      append(out.get(rng.nextInt(out.size())), true);
    }
  }

  private void join() {
    if (joinersLeft > 0) {
      joinersLeft--;
      append(birth().id, true);
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
  }

  private void leave() {
    if (!leaving.isEmpty()) {
      append(leaving.remove(rng.nextInt(leaving.size())), false);
    }
  }

  /**
   * Puts one out although it may be up: a member that it needs, and that has granted it nothing that
   * is open, vows never to grant it anything again; then no view is unsafe that lacks it.
   */
  private void exclude() {
    if (exclusionsLeft == 0) {
      return;
    }
    Optional<MutexNode> fencer = any(node -> !node.dead && last().contains(node.id));
    Optional<MutexNode> victim = any(node -> last().contains(node.id));
    if (fencer.isPresent() && victim.isPresent() && fencer.get() != victim.get()) {
      ProcessId by = fencer.get().id;
      ProcessId whom = victim.get().id;
      boolean isElder = last().admittedBy(by) <= last().admittedBy(whom);
      if (isElder && fencer.get().protocol.open(whom).isEmpty()) {
        exclusionsLeft--;
        fences.add(List.of(by, whom));
        // Forgets what it keeps back, as if that were over.
        long num = Math.max(1, victim.get().num);
        fencer.get().protocol.receive(new MutexMessage.Rem(whom, by, num, Sections.NONE));
        append(whom, false);
      }
    }
  }

  private void crash() {
    if (crashesLeft > 0) {
      any(node -> !node.dead).ifPresent(this::crash);
    }
  }

  private void crash(MutexNode node) {
    crashesLeft--;
    node.dead = true;
    if (shape.fault() == ViewFault.RESTARTS_UNDER_THE_OLD_ID && node.protocol.held().isEmpty()) {
      nodes.remove(node);
      MutexNode again = new MutexNode(node.id, kind, this::send, this::trace);
      again.protocol.learn(last());
      nodes.add(again);
    }
  }

  private View last() {
    return log.get(log.size() - 1);
  }

  private void append(ProcessId id, boolean isIn) {
    if (last().contains(id) == isIn) {
      return;
    }
    SortedMap<ProcessId, Long> admitted = new TreeMap<>(last().admitted());
    if (isIn) {
      admitted.put(id, last().number() + 1);
    } else {
      admitted.remove(id);
      out.add(id);
    }
    log.add(new View(last().number() + 1, admitted));
    changes++;
  }

  private MutexNode birth() {
    born++;
    ProcessId id = new ProcessId(new RobotId("p" + born), 1);
    MutexNode node = new MutexNode(id, kind, this::send, this::trace);
    // Names are no order of birth, so that a newcomer may win a tie.
    nodes.add(rng.nextInt(nodes.size() + 1), node);
    return node;
  }

  private void trace(MutexEvent event) {
    changes++;
    entries += event instanceof MutexEvent.OdMutex ? 1 : 0;
    failures += event instanceof MutexEvent.Withdraw ? 1 : 0;
    monitors.observe(
        new TraceEvent.Action(
            nowNs, event.who().robot(), "mutex/x", MutexTrace.name(event), MutexTrace.args(event)));
  }

  private Optional<MutexNode> any(Predicate<MutexNode> such) {
    List<MutexNode> all = nodes.stream().filter(such).toList();
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(rng.nextInt(all.size())));
  }

  private TreeSet<String> someSections() {
    TreeSet<String> all = new TreeSet<>();
    for (int i = 0; i < shape.sections(); i++) {
      all.add(String.valueOf((char) ('A' + i)));
    }
    return someOf(all);
  }

  private TreeSet<String> someOf(Set<String> names) {
    TreeSet<String> some = new TreeSet<>();
    List<String> all = List.copyOf(new TreeSet<>(names));
    for (String name : all) {
      if (rng.nextBoolean(0.5)) {
        some.add(name);
      }
    }
    if (some.isEmpty()) {
      some.add(all.get(rng.nextInt(all.size())));
    }
    return some;
  }
}
