package org.starl.sim.explore;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.fault.Fault;

/** Runs schedules until one of them ends badly or none is left. */
public final class Explorer {

  /** Runs whose orders are in memory at the same time. */
  private static final int BATCH = 256;

  private final Exploration exploration;
  private final Runner runner;
  private final int workers;
  private final Progress progress;

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

  /**
   * @param workers threads
   */
  public Explorer(Exploration exploration, Runner runner, int workers, Progress progress) {
    this.exploration = exploration;
    this.runner = runner;
    this.workers = workers;
    this.progress = progress;
  }

  /** On all cores, without progress. */
  public Explorer(Exploration exploration, Runner runner) {
    this(
        exploration, runner, Runtime.getRuntime().availableProcessors(), (finished, planned) -> {});
  }

  /** Explores the whole. */
  public Result run() throws InterruptedException {
    ExplorationTally tally = new ExplorationTally(exploration);
    boolean isAll = run(any -> true, List.of(), tally::add);
    return tally.result(isAll);
  }

  /**
   * Explores a part. The parts of one exploration, each by a process of its own, have together the
   * schedules of the whole, each once; the first bad schedule of a part ends it. Some schedules run
   * in each part, because the others follow from them.
   *
   * @param isOwn whether the part has the schedule of a {@link Explored#place}. In an exhaustive
   *     search it must answer equally for places with equal first numbers
   * @param kept the first schedules of this part, which ran before
   * @param isLast called for each further schedule of the part, in order; after the first true the
   *     exploration ends
   * @return whether no schedule is left
   * @throws IllegalArgumentException if {@code kept} are not the first ones
   */
  public boolean run(Predicate<List<Long>> isOwn, List<Explored> kept, Predicate<Explored> isLast)
      throws InterruptedException {
    Search search =
        exploration.strategy() == Strategy.EXHAUSTIVE
            ? new ExhaustiveSearch(exploration, isOwn)
            : new DrawnSearch(exploration, isOwn);
    Part part = new Part(search, isOwn, new ArrayDeque<>(kept), isLast);
    while (!part.isOver && part.taken < exploration.mostSchedules()) {
      long most = Math.min(BATCH, exploration.mostSchedules() - part.taken);
      List<Search.Node> batch = search.next((int) most);
      if (batch.isEmpty()) {
        break;
      }
      part.run(batch);
    }
    if (!part.kept.isEmpty()) {
      throw new IllegalArgumentException(
          "schedule " + part.kept.remove().place() + ": expected none after the last one");
    }
    return search.isAll();
  }

  /** The schedules of one process, so far. */
  private final class Part {
    private final Search search;
    private final Predicate<List<Long>> isOwn;
    private final Queue<Explored> kept;
    private final Predicate<Explored> isLast;
    private long taken;
    private boolean isOver;

    Part(
        Search search,
        Predicate<List<Long>> isOwn,
        Queue<Explored> kept,
        Predicate<Explored> isLast) {
      this.search = search;
      this.isOwn = isOwn;
      this.kept = kept;
      this.isLast = isLast;
    }

    /** Runs the schedules up to the first bad one. */
    void run(List<Search.Node> batch) throws InterruptedException {
      Map<Long, Explored> before = before(batch);
      Map<Long, Order> orders = new ConcurrentHashMap<>();
      long already = taken;
      new Campaign(0, batch.size() - 1, workers, true)
          .run(
              number -> {
                Explored old = before.get(number);
                Search.Node node = batch.get((int) number);
                if (old != null && !search.needsAgain(node)) {
                  return old.outcome();
                }
                Order order = new Order(exploration.bounds(), search.mostCopies(node));
                orders.put(number, order);
                return outcome(node.schedule(), order);
              },
              (finished, planned, bad) ->
                  progress.ran(already + finished, exploration.mostSchedules()),
              run -> {
                long number = run.seed();
                take(
                    batch.get((int) number), before.get(number), run.outcome(), orders.get(number));
                return isOver;
              });
    }

    /** Those of the batch that ran before, by their index. */
    private Map<Long, Explored> before(List<Search.Node> batch) {
      Map<Long, Explored> before = new TreeMap<>();
      for (int i = 0; i < batch.size() && !kept.isEmpty(); i++) {
        List<Long> place = batch.get(i).place();
        if (isOwn.test(place)) {
          Explored old = kept.remove();
          if (!old.place().equals(place)) {
            throw new IllegalArgumentException(
                "schedule " + old.place() + ": expected " + place + " before it");
          }
          before.put((long) i, old);
        }
      }
      return before;
    }

    private void take(
        Search.Node node, @Nullable Explored old, RunOutcome outcome, @Nullable Order order) {
      Explored ran = order == null ? null : search.explored(node, outcome, order);
      Explored explored = Objects.requireNonNull(old != null ? old : ran);
      search.took(explored);
      isOver = !outcome.isGood();
      if (isOwn.test(node.place())) {
        taken++;
        isOver |= old == null && isLast.test(explored);
      }
    }
  }

  private RunOutcome outcome(List<Fault> schedule, Order order) {
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
