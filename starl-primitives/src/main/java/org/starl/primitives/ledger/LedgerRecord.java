package org.starl.primitives.ledger;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.ledger.LedgerEntry.Add;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.primitives.ledger.LedgerEntry.Finish;
import org.starl.primitives.ledger.LedgerEntry.Free;
import org.starl.primitives.ledger.LedgerEntry.Reopen;
import org.starl.primitives.ledger.LedgerEntry.Start;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Sent;

/**
 * One ledger, as {@link LedgerSpec} sees it in the trace: what the first robot at each number applied, and
 * what follows from that. Memory grows with the tasks.
 */
final class LedgerRecord {

  /** Older decrees are forgotten: no robot is so far behind. */
  private static final int KEPT_NUMBERS = 1024;

  private final Instance source;
  private final Set<RobotId> voters = new TreeSet<>();
  // By the robot and the voter: its beacons since it has asked that voter.
  private final Map<RobotId, Map<String, Integer>> unasked = new TreeMap<>();
  private final Set<RobotId> seen = new TreeSet<>();
  private final Map<RobotId, Integer> open = new TreeMap<>();
  private final TreeMap<Long, First> decrees = new TreeMap<>();
  private final Map<TaskId, Task> tasks = new TreeMap<>();
  private final Map<RobotId, ProcessId> programs = new TreeMap<>();
  private int unfinished;

  // The first and the last decree that each robot has by itself, as it must keep them.
  private final Map<RobotId, long[]> had = new TreeMap<>();
  private final Map<RobotId, Set<LedgerEntry>> freed = new TreeMap<>();
  private final Map<RobotId, Own> owns = new TreeMap<>();

  LedgerRecord(Instance source) {
    this.source = source;
  }

  /** The first robot at a number, what it applied, and how many tasks are not finished then. */
  private record First(RobotId robot, List<LedgerEntry> entries, int tasks) {}

  /** What the log says of one task. */
  private static final class Task {
    private @Nullable RobotId claimant;
    private @Nullable ProcessId holder;
    private @Nullable RobotId worker;
    private boolean isFinished;

    // By the claim's number.
    private final TreeMap<Long, ProcessId> claims = new TreeMap<>();
    private final Map<Long, RobotId> begun = new TreeMap<>();

    // By the claim's number, the decree.
    private final Map<Long, Long> begunIn = new TreeMap<>();

    /** Whether this claim has been made, and has not ended. */
    private boolean runs(long claim) {
      boolean isLatest = !claims.isEmpty() && claims.lastKey() == claim;
      return isLatest && (claimant != null || worker != null);
    }
  }

  /** What the log says of one robot's tasks, as far as the robot has the log. */
  private static final class Own {
    private long number;
    private boolean isKnown = true;
    private boolean hasStarted;

    // Whether the robot has begun it.
    private final SortedMap<TaskId, Boolean> tasks = new TreeMap<>();

    private void take(LedgerEntry entry, RobotId robot) {
      switch (entry) {
        case Start e when e.who().robot().equals(robot) -> {
          hasStarted = true;
          tasks.values().removeIf(isBegun -> !isBegun);
        }
        case Claim e when e.who().robot().equals(robot) -> tasks.put(e.task(), false);
        case Begin e when e.who().robot().equals(robot) -> tasks.put(e.task(), true);
        case Finish e -> tasks.remove(e.task());
        case Free e -> tasks.remove(e.task());
        case Reopen e -> tasks.remove(e.task());
        default -> {
          // Of no task of this robot.
        }
      }
    }
  }

  /** The robot has the log up to {@code number}, later than before since its start. */
  void knows(RobotId robot, long number, boolean isInstalled) {
    if (isInstalled) {
      owns.remove(robot);
    }
    Own own = owns.computeIfAbsent(robot, any -> new Own());
    while (own.isKnown && own.number < number) {
      own.number++;
      First next = decrees.get(own.number);
      own.isKnown = next != null;
      if (next != null) {
        next.entries().forEach(entry -> own.take(entry, robot));
      }
    }
  }

  /** Whether the robot's log, if it is known, says that the robot holds these tasks. */
  boolean holds(RobotId robot, SortedSet<TaskId> shown) {
    Own own = owns.get(robot);
    return own == null || !own.isKnown || own.tasks.keySet().equals(shown);
  }

  /** Whether the robot's log may have the start of its program. */
  boolean mayBeReady(RobotId robot) {
    Own own = owns.get(robot);
    return own == null || !own.isKnown || own.hasStarted;
  }

  void voters(List<RobotId> robots) {
    voters.addAll(robots);
  }

  Set<RobotId> voters() {
    return voters;
  }

  /** All robots that have had a claim, in order. */
  Set<RobotId> robots() {
    return seen;
  }

  /** Whether the robot asks each voter with one of as many beacons as there are voters. */
  boolean asksInTurn(Sent sent, boolean asks) {
    Map<String, Integer> counts = unasked.computeIfAbsent(sent.robot(), robot -> new TreeMap<>());
    int count = asks ? 0 : counts.getOrDefault(sent.to(), 0) + 1;
    counts.put(sent.to(), count);
    return count < voters.size();
  }

  void asked(LedgerEntry entry, Action event, Report report) {
    RobotId robot = event.robot();
    open.merge(robot, 1, Integer::sum);
    if (entry instanceof Free e && e.claim() > 0) {
      ProcessId holder = task(e.task(), event, report).claims.get(e.claim());
      boolean isOwn = holder != null && holder.robot().equals(robot);
      check(LedgerSpec.TOLD, isOwn, event, "gives back the claim of " + holder, report);
    }
  }

  boolean isAnswered(RobotId robot) {
    return open.getOrDefault(robot, 0) == 0;
  }

  void ended(RobotId robot) {
    open.remove(robot);
    had.remove(robot);
    freed.remove(robot);
    owns.remove(robot);
    unasked.remove(robot);
  }

  /** Whether the robot must have this decree, to tell it to others. */
  boolean has(RobotId robot, long number) {
    long[] its = had.get(robot);
    return its != null && its[0] <= number && number <= its[1];
  }

  /** The holders whose claims the robot now wishes to end, for the first time. */
  List<ProcessId> newlyFreedBy(RobotId robot, List<LedgerEntry> wish) {
    List<ProcessId> holders = new ArrayList<>();
    for (LedgerEntry entry : wish) {
      if (entry instanceof Free e
          && freed.computeIfAbsent(robot, r -> new LinkedHashSet<>()).add(e)) {
        Task task = tasks.get(e.task());
        if (task != null && task.claimant != null && task.holder != null) {
          holders.add(task.holder);
        }
      }
    }
    return holders;
  }

  /** Whether it ends a claim though a decree before {@code number} says that its task was begun. */
  boolean endsBegun(List<LedgerEntry> wish, long number) {
    for (LedgerEntry entry : wish) {
      Task task = entry instanceof Free e ? tasks.get(e.task()) : null;
      if (entry instanceof Free e
          && task != null
          && task.begunIn.getOrDefault(e.claim(), number) < number) {
        return true;
      }
    }
    return false;
  }

  boolean hasClaim(RobotId robot) {
    return tasks.values().stream().anyMatch(task -> robot.equals(task.claimant));
  }

  void applied(LedgerFact.Applied decree, Action event, Report report) {
    long number = decree.number();
    had.merge(
        event.robot(),
        new long[] {number, number},
        (its, one) ->
            new long[] {Math.max(its[0], number + 1 - LedgerProtocol.KEPT_DECREES), number});
    if (decrees.isEmpty() || number > decrees.lastKey()) {
      decree.entries().forEach(entry -> take(number, entry, event, report));
      decrees.put(number, new First(event.robot(), decree.entries(), unfinished));
      if (decrees.size() > KEPT_NUMBERS) {
        decrees.pollFirstEntry();
      }
    }
    First first = decrees.get(number);
    if (first != null) {
      check(
          LedgerSpec.ONE_LOG,
          first.entries().equals(decree.entries()),
          event,
          first.robot() + " applied " + first.entries() + " at " + number,
          report);
      kept(number, decree.tasks(), first, event, report);
    }
  }

  void installed(LedgerFact.Installed known, Action event, Report report) {
    had.put(event.robot(), new long[] {known.number() + 1, known.number()});
    First first = decrees.get(known.number());
    if (first != null) {
      kept(known.number(), known.tasks(), first, event, report);
    }
  }

  private void kept(long number, int has, First first, Action event, Report report) {
    check(
        LedgerSpec.KEPT,
        has == first.tasks(),
        event,
        "has " + has + " tasks at " + number + ", but " + first.tasks() + " are not finished",
        report);
  }

  private void take(long number, LedgerEntry entry, Action event, Report report) {
    switch (entry) {
      case Start e -> {
        ProcessId before = programs.put(e.who().robot(), e.who());
        boolean isNew = before == null || before.compareTo(e.who()) < 0;
        check(LedgerSpec.PRESENT, isNew, event, e + " after that of " + before, report);
        tasks.values().stream()
            .filter(task -> e.who().robot().equals(task.claimant))
            .forEach(task -> task.claimant = null);
      }
      case Add e -> {
        check(LedgerSpec.KEPT, tasks.put(e.task(), new Task()) == null, event, "twice", report);
        unfinished++;
      }
      case Claim e -> {
        Task task = task(e.task(), event, report);
        boolean isFree = task.claimant == null && task.worker == null && !task.isFinished;
        check(LedgerSpec.BEGUN_BY_ONE, isFree, event, e + " of a task that is not open", report);
        checkPresent(e.who(), e, event, report);
        task.claimant = e.who().robot();
        task.holder = e.who();
        task.claims.put(e.claim(), e.who());
        seen.add(e.who().robot());
      }
      case Begin e -> {
        Task task = task(e.task(), event, report);
        boolean isClaimed = e.who().robot().equals(task.claimant) && task.worker == null;
        check(LedgerSpec.BEGUN_BY_ONE, isClaimed, event, e + " without a claim", report);
        task.claimant = null;
        task.worker = e.who().robot();
        task.begun.put(e.claim(), e.who().robot());
        task.begunIn.put(e.claim(), number);
      }
      case Finish e -> {
        Task task = task(e.task(), event, report);
        boolean isRight = e.who().robot().equals(task.worker) && !task.isFinished;
        check(LedgerSpec.FINISHED_ONCE, isRight, event, e + " without its begin", report);
        checkPresent(e.who(), e, event, report);
        task.worker = null;
        task.isFinished = true;
        unfinished--;
      }
      case Free e -> task(e.task(), event, report).claimant = null;
      case Reopen e -> task(e.task(), event, report).worker = null;
    }
  }

  /** What an earlier program of a robot wanted is void. */
  private void checkPresent(ProcessId who, LedgerEntry entry, Action event, Report report) {
    boolean isPresent = who.equals(programs.get(who.robot()));
    check(LedgerSpec.PRESENT, isPresent, event, entry + " of a program that has ended", report);
  }

  private Task task(TaskId id, Action event, Report report) {
    check(LedgerSpec.KEPT, tasks.containsKey(id), event, id + " was never added", report);
    return tasks.computeIfAbsent(id, any -> new Task());
  }

  void told(LedgerFact.Told told, Action event, Report report) {
    open.computeIfPresent(event.robot(), (robot, calls) -> calls - 1);
    if (told.outcome() != LedgerOutcome.DONE) {
      return;
    }
    switch (told.entry()) {
      case Add e -> task(e.task(), event, report);
      case Begin e -> {
        RobotId worker = task(e.task(), event, report).begun.get(e.claim());
        check(
            LedgerSpec.BEGUN_BY_ONE,
            event.robot().equals(worker),
            event,
            "was told to do " + e.task() + ", which " + worker + " has begun",
            report);
      }
      case Finish e ->
          check(
              LedgerSpec.FINISHED_ONCE,
              task(e.task(), event, report).isFinished,
              event,
              "was told that " + e.task() + " is finished",
              report);
      case Claim e -> {
        ProcessId holder = task(e.task(), event, report).claims.get(e.claim());
        String wrong = "was told of " + e + ", which is of " + holder;
        check(LedgerSpec.TOLD, e.who().equals(holder), event, wrong, report);
      }
      case Free e -> checkEnded(e, event, report);
      case Reopen e -> checkEnded(e, event, report);
      case Start e -> {} // no call
    }
  }

  private void checkEnded(LedgerEntry.OfClaim end, Action event, Report report) {
    boolean runs = task(end.task(), event, report).runs(end.claim());
    check(LedgerSpec.TOLD, !runs, event, "was told of " + end + ", and the claim stands", report);
  }

  private void check(String lemma, boolean holds, Action event, String wrong, Report report) {
    report.checked(lemma);
    if (!holds) {
      report.violated(
          lemma,
          event.timeNs(),
          List.of(event.robot()),
          source + ": " + event.robot() + " " + wrong);
    }
  }
}
