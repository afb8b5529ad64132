package org.starl.sim.explore;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.explore.Explored.Change;
import org.starl.sim.fault.Fault;

/**
 * Tries every order in which the first copies can arrive, those with the fewest changes first.
 *
 * <p>The schedules are a tree, whose parts are those with the same first change. What follows an
 * order that was seen was seen too; it is left out if it was seen in the same part, or in a schedule
 * with one change or none. So parts do not depend on each other, if each process runs all schedules
 * with one change.
 */
final class ExhaustiveSearch implements Search {

  private final Exploration exploration;
  private final Bounds bounds;
  private final Predicate<List<Long>> isOwn;
  private final Deque<Node> left = new ArrayDeque<>();

  /** Orders of the schedules with at most one change. */
  private final Set<Long> common = new TreeSet<>();

  /** The other orders of each part. */
  private final Map<Long, Set<Long>> ofParts = new TreeMap<>();

  /**
   * @param isOwn whether a place is in a part to search; all schedules with at most one change run
   */
  ExhaustiveSearch(Exploration exploration, Predicate<List<Long>> isOwn) {
    this.exploration = exploration;
    this.isOwn = isOwn;
    bounds = exploration.bounds();
    left.add(new Node(List.of(), List.of(), 0, 0, 0));
  }

  @Override
  public List<Node> next(int most) {
    List<Node> next = new ArrayList<>();
    while (next.size() < most && !left.isEmpty()) {
      next.add(left.remove());
    }
    return next;
  }

  @Override
  public int mostCopies(Node node) {
    return exploration.depth();
  }

  @Override
  public boolean needsAgain(Node node) {
    return false;
  }

  @Override
  public Explored explored(Node node, RunOutcome outcome, Order order) {
    long hash = order.hash();
    boolean isContinued =
        outcome.isGood()
            && !isSeen(node.place(), hash)
            && (node.place().isEmpty() || isOwn.test(node.place()));
    List<Change> next = isContinued ? changes(node, order) : List.of();
    return new Explored(node.place(), node.schedule(), outcome, hash, order.steps(), next);
  }

  private boolean isSeen(List<Long> place, long order) {
    return common.contains(order)
        || (place.size() > 1 && ofParts.getOrDefault(place.get(0), Set.of()).contains(order));
  }

  @Override
  public void took(Explored explored) {
    List<Long> place = explored.place();
    Long order = explored.order();
    if (order != null) {
      Set<Long> seen =
          place.size() <= 1
              ? common
              : ofParts.computeIfAbsent(place.get(0), any -> new TreeSet<>());
      seen.add(order);
    }
    for (int i = 0; i < explored.next().size(); i++) {
      Change change = explored.next().get(i);
      List<Long> longer = new ArrayList<>(place);
      longer.add((long) i);
      List<Fault> schedule = new ArrayList<>(explored.schedule());
      schedule.add(change.fault());
      left.add(new Node(longer, schedule, change.decided(), change.losses(), change.crashes()));
    }
  }

  private List<Change> changes(Node node, Order order) {
    List<Change> next = new ArrayList<>();
    List<Copy> copies = order.copies();
    for (int i = node.decided(); i < copies.size(); i++) {
      Copy copy = copies.get(i);
      for (long arrivesAtNs : copy.isLost() ? List.<Long>of() : order.otherArrivals(copy)) {
        Fault fault = copy.arrivingAt(arrivesAtNs);
        next.add(new Change(fault, i + 1, node.losses(), node.crashes()));
      }
      if (node.losses() < bounds.losses() && !copy.isLost()) {
        next.add(new Change(copy.lost(), i + 1, node.losses() + 1, node.crashes()));
      }
      if (node.crashes() < bounds.crashes()) {
        addCrash(node, i, copy.from(), copy.sentAtNs(), next);
        if (!copy.isLost()) {
          addCrash(node, i, copy.to(), copy.arrivesAtNs(), next);
        }
      }
    }
    return next;
  }

  private void addCrash(Node node, int copy, String robot, long afterNs, List<Change> next) {
    Fault crash = Draws.crash(robot, afterNs + 1, bounds);
    next.add(new Change(crash, copy + 1, node.losses(), node.crashes() + 1));
  }

  @Override
  public boolean isAll() {
    return left.isEmpty();
  }
}
