package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * A closed group in virtual time. Each message takes at most delta; each holder releases its
 * sections in parts within d1, and requests other sections some time later.
 */
final class MutexTimedWorld {

  /**
   * The parameters of a run.
   *
   * @param holdFactor the factor by which a holder may exceed d1; 1 if the assumptions hold
   */
  record Shape(int members, int sections, long d1Ms, long deltaMs, int holdFactor) {}

  private record Due(long atNs, long seq, Runnable action) {}

  final TreeMap<ProcessId, Long> entries = new TreeMap<>();
  long longestWaitNs;

  private final Shape shape;
  private final Rng rng;
  private final Monitors monitors;
  private final List<MutexNode> nodes = new ArrayList<>();
  private final TreeMap<ProcessId, Long> askedAtNs = new TreeMap<>();
  private final PriorityQueue<Due> queue =
      new PriorityQueue<>(Comparator.comparingLong(Due::atNs).thenComparingLong(Due::seq));
  private long nowNs;
  private long seq;

  MutexTimedWorld(Shape shape, MutexBounds bounds, MutexNode.Kind kind, long seed) {
    this.shape = shape;
    rng = new Rng(seed);
    monitors = new Monitors(List.of(new MutexSpec(bounds)));
    List<ProcessId> ids = new ArrayList<>();
    for (int i = 0; i < shape.members(); i++) {
      ids.add(ProcessId.first(new RobotId("p" + i), 1));
    }
    for (ProcessId id : ids) {
      MutexNode node = new MutexNode(id, kind, this::send, this::trace);
      node.protocol.learn(View.closed(ids));
      nodes.add(node);
      entries.put(id, 0L);
      after(rng.nextLong(0, 2 * shape.d1Ms()), () -> ask(node));
    }
  }

  SpecReport run(long forMs) {
    long endNs = forMs * NS_PER_MS;
    while (!queue.isEmpty() && queue.element().atNs() <= endNs) {
      Due due = queue.remove();
      nowNs = due.atNs();
      due.action().run();
    }
    monitors.finish(endNs);
    return monitors.report();
  }

  private void after(long ms, Runnable action) {
    queue.add(new Due(nowNs + ms * NS_PER_MS, seq++, action));
  }

  private void ask(MutexNode node) {
    TreeSet<String> some = new TreeSet<>();
    int count = 1 + rng.nextInt(shape.sections());
    for (int i = 0; i < count; i++) {
      some.add("s" + rng.nextInt(shape.sections()));
    }
    askedAtNs.put(node.id, nowNs);
    node.protocol.request(some, nowNs);
  }

  private void send(MutexMessage message) {
    after(
        rng.nextLong(0, shape.deltaMs()),
        () ->
            nodes.stream()
                .filter(node -> node.id.equals(message.to()))
                .forEach(node -> node.protocol.receive(message, nowNs)));
  }

  private void giveBack(MutexNode node, long withinMs) {
    TreeSet<String> held = new TreeSet<>(node.protocol.held());
    if (withinMs > 0 && held.size() > 1) {
      node.protocol.release(new TreeSet<>(List.of(held.first())));
      long nextMs = rng.nextLong(0, withinMs);
      after(nextMs, () -> giveBack(node, withinMs - nextMs));
    } else {
      node.protocol.release(held);
      after(rng.nextLong(0, 2 * shape.d1Ms()), () -> ask(node));
    }
  }

  private void trace(MutexFact event) {
    monitors.observe(
        TraceEvent.Action.of(
            nowNs, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event));
    if (event instanceof MutexFact.OdMutex) {
      entries.merge(event.who(), 1L, Long::sum);
      longestWaitNs = Math.max(longestWaitNs, nowNs - askedAtNs.get(event.who()));
      long limitMs = shape.d1Ms() * shape.holdFactor();
      long firstMs = rng.nextLong(0, limitMs);
      MutexNode node =
          nodes.stream().filter(each -> each.id.equals(event.who())).findFirst().orElseThrow();
      after(firstMs, () -> giveBack(node, limitMs - firstMs));
    }
  }
}
