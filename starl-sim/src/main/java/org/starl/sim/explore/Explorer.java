package org.starl.sim.explore;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.starl.random.Rng;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.fault.Fault;

/** Runs schedules, on all cores, until one of them ends badly or none is left. */
public final class Explorer {

  /** Copies that a drawn schedule can choose from. */
  private static final int MOST_DRAWN_FROM = 100_000;

  /** Copies of a drawn schedule that make its order. */
  private static final int COPIES_OF_ORDER = 1000;

  /** Runs whose orders are in memory at the same time. */
  private static final int BATCH = 256;

  private final Bounds bounds;
  private final Runner runner;
  private final int mostSchedules;
  private final Progress progress;
  private final Set<Long> orders = new LinkedHashSet<>();
  private long schedules;
  private long steps;
  private @Nullable Found found;

  /** Builds and executes one run. */
  @FunctionalInterface
  public interface Runner {

    /**
     * Called on several threads at once.
     *
     * @param schedule faults in addition to those of the run
     * @param order to observe the run
     */
    RunOutcome run(List<Fault> schedule, Order order);
  }

  /** Called after each run, on the calling thread. */
  @FunctionalInterface
  public interface Progress {

    /**
     * @param planned the largest number of runs
     */
    void ran(long finished, long planned);
  }

  /**
   * A schedule that ended badly.
   *
   * @param number of the schedule, from 0, which is the run without changes
   */
  public record Found(long number, List<Fault> schedule, RunOutcome outcome) {}

  /**
   * What was explored.
   *
   * @param orders the number of different orders among the schedules
   * @param steps events of the kernel in all runs
   * @param isComplete whether no schedule within the bounds is left
   * @param found the first bad schedule, or null
   */
  public record Result(
      long schedules, long orders, long steps, boolean isComplete, @Nullable Found found) {}

  /** A schedule, and the number of copies that are decided: later ones may still be changed. */
  private record Node(List<Fault> schedule, int decided, int losses, int crashes) {}

  public Explorer(Bounds bounds, Runner runner, int mostSchedules, Progress progress) {
    this.bounds = bounds;
    this.runner = runner;
    this.mostSchedules = mostSchedules;
    this.progress = progress;
  }

  /**
   * Draws schedules.
   *
   * @param changes of priorities, for {@link Strategy#PCT}
   * @param seed of the draws
   */
  public Result draw(Strategy strategy, int changes, long seed) throws InterruptedException {
    Order first = run(List.of(List.of()), MOST_DRAWN_FROM).get(0);
    Draws draws = new Draws(bounds, first);
    while (found == null && schedules < mostSchedules) {
      List<List<Fault>> drawn = new ArrayList<>();
      for (long i = schedules; i < mostSchedules && drawn.size() < BATCH; i++) {
        Rng rng = new Rng(seed).fork(strategy + "/" + i);
        drawn.add(strategy == Strategy.PCT ? draws.pct(changes, rng) : draws.random(rng));
      }
      run(drawn, COPIES_OF_ORDER).forEach(order -> orders.add(order.hash()));
    }
    return new Result(schedules, orders.size(), steps, false, found);
  }

  /**
   * Tries every order in which the first copies can arrive.
   *
   * @param choices the number of copies
   */
  public Result exhaust(int choices) throws InterruptedException {
    List<Node> level = List.of(new Node(List.of(), 0, 0, 0));
    boolean isCut = false;
    while (found == null && !level.isEmpty() && !isCut) {
      long left = mostSchedules - schedules;
      isCut = level.size() > left;
      List<Node> now = isCut ? level.subList(0, (int) left) : level;
      level = next(now, choices);
    }
    return new Result(schedules, orders.size(), steps, found == null && !isCut, found);
  }

  /** Runs the nodes, and returns those with one change more. */
  private List<Node> next(List<Node> nodes, int choices) throws InterruptedException {
    List<Node> next = new ArrayList<>();
    for (int begin = 0; found == null && begin < nodes.size(); begin += BATCH) {
      List<Node> batch = nodes.subList(begin, Math.min(begin + BATCH, nodes.size()));
      List<Order> runs = run(batch.stream().map(Node::schedule).toList(), choices);
      for (int i = 0; found == null && i < runs.size(); i++) {
        // What follows an order that was seen was seen too.
        if (orders.add(runs.get(i).hash())) {
          addChanges(batch.get(i), runs.get(i), next);
        }
      }
    }
    return next;
  }

  private void addChanges(Node node, Order order, List<Node> next) {
    List<Copy> copies = order.copies();
    for (int i = node.decided(); i < copies.size(); i++) {
      Copy copy = copies.get(i);
      for (long arrivesAtNs : copy.isLost() ? List.<Long>of() : order.otherArrivals(copy)) {
        next.add(
            new Node(
                with(node, copy.arrivingAt(arrivesAtNs)), i + 1, node.losses(), node.crashes()));
      }
      if (node.losses() < bounds.losses() && !copy.isLost()) {
        next.add(new Node(with(node, copy.lost()), i + 1, node.losses() + 1, node.crashes()));
      }
      if (node.crashes() < bounds.crashes()) {
        addCrash(node, i, copy.from(), copy.sentAtNs(), next);
        if (!copy.isLost()) {
          addCrash(node, i, copy.to(), copy.arrivesAtNs(), next);
        }
      }
    }
  }

  private void addCrash(Node node, int copy, String robot, long afterNs, List<Node> next) {
    Fault crash = Draws.crash(robot, afterNs + 1, bounds);
    next.add(new Node(with(node, crash), copy + 1, node.losses(), node.crashes() + 1));
  }

  private static List<Fault> with(Node node, Fault change) {
    List<Fault> schedule = new ArrayList<>(node.schedule());
    schedule.add(change);
    return schedule;
  }

  /** Runs the schedules up to the first bad one, and returns their orders. */
  private List<Order> run(List<List<Fault>> wanted, int mostCopies) throws InterruptedException {
    if (wanted.isEmpty()) {
      return List.of();
    }
    Map<Long, Order> ran = new ConcurrentHashMap<>();
    int cores = Runtime.getRuntime().availableProcessors();
    CampaignResult result =
        new Campaign(0, wanted.size() - 1, cores, true)
            .run(
                number -> {
                  Order order = new Order(bounds, mostCopies);
                  ran.put(number, order);
                  List<Fault> schedule = wanted.get((int) number);
                  return run(schedule, order);
                },
                (finished, planned, bad) -> progress.ran(schedules + finished, mostSchedules));
    List<Order> inOrder = new ArrayList<>();
    for (CampaignResult.Run run : result.runs()) {
      Order order = Objects.requireNonNull(ran.get(run.seed()));
      inOrder.add(order);
      steps += order.steps();
      if (!run.outcome().isGood()) {
        found = new Found(schedules + run.seed(), wanted.get((int) run.seed()), run.outcome());
      }
    }
    schedules += result.runs().size();
    return inOrder;
  }

  private RunOutcome run(List<Fault> schedule, Order order) {
    RunOutcome outcome;
    try {
      outcome = runner.run(schedule, order);
    } catch (RuntimeException e) {
      outcome = RunOutcome.failed(e);
    }
    // A robot that has not joined yet cannot crash: there is no such run.
    return outcome.isBadInput() && !schedule.isEmpty() ? RunOutcome.good(new TreeMap<>()) : outcome;
  }
}
