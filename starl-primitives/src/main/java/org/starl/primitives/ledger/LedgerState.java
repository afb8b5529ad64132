package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.part;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.ledger.LedgerEntry.Add;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.primitives.ledger.LedgerEntry.Finish;
import org.starl.primitives.ledger.LedgerEntry.Free;
import org.starl.primitives.ledger.LedgerEntry.OfClaim;
import org.starl.primitives.ledger.LedgerEntry.Reopen;
import org.starl.primitives.ledger.LedgerEntry.Start;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The log up to a decree, in short: its size is bounded by the tasks that are not finished, the robots
 * and the sources of tasks. Equal logs give equal states.
 */
final class LedgerState {

  private static final int MOST = 0xFFFF;

  /** Its shape on stable storage, and for a robot that is far behind. */
  static final Shape<LedgerState> SHAPE =
      Shapes.of(
          LedgerState.class,
          part("number", Shapes.LONG, LedgerState::number),
          part("last", Value.SHAPE, LedgerState::last),
          part("programs", Shapes.map(Shapes.ROBOT, Shapes.PROCESS, MOST), s -> s.programs),
          part("added", Shapes.map(Shapes.TEXT, Shapes.LONG, MOST), s -> s.added),
          part("tasks", Shapes.map(TaskId.SHAPE, LedgerTask.SHAPE, MOST), s -> s.tasks),
          LedgerState::new);

  private long number;
  private Value last;
  private final TreeMap<RobotId, ProcessId> programs;
  private final TreeMap<String, Long> added;
  private final TreeMap<TaskId, LedgerTask<Value>> tasks;

  private LedgerState(
      long number,
      Value last,
      SortedMap<RobotId, ProcessId> programs,
      SortedMap<String, Long> added,
      SortedMap<TaskId, LedgerTask<Value>> tasks) {
    this.number = number;
    this.last = last;
    this.programs = new TreeMap<>(programs);
    this.added = new TreeMap<>(added);
    this.tasks = new TreeMap<>(tasks);
  }

  LedgerState() {
    this(0, Value.EMPTY, new TreeMap<>(), new TreeMap<>(), new TreeMap<>());
  }

  /** The number of the latest decree; 0 for none. */
  long number() {
    return number;
  }

  /** The latest decree. */
  Value last() {
    return last;
  }

  SortedMap<TaskId, LedgerTask<Value>> tasks() {
    return tasks;
  }

  @Nullable LedgerTask<Value> task(TaskId id) {
    return tasks.get(id);
  }

  /** The number of the latest task of a source; 0 before the first. */
  long added(String source) {
    return added.getOrDefault(source, 0L);
  }

  /** The present program of a robot, as far as the log tells; null before its first. */
  @Nullable ProcessId program(RobotId robot) {
    return programs.get(robot);
  }

  /** The next decree begins. */
  void next(long decree, Value value) {
    number = decree;
    last = value;
  }

  /** Whether the entry would take effect now: {@code Ledger_decls}, the guards of its actions. */
  boolean allows(LedgerEntry entry) {
    return switch (entry) {
      case Start e -> {
        ProcessId known = programs.get(e.who().robot());
        yield known == null || known.compareTo(e.who()) < 0;
      }
      case Add e ->
          e.task().number() == added(e.task().source()) + 1
              && tasks.size() < MOST
              && (added.containsKey(e.task().source()) || added.size() < MOST);
      case OfClaim e -> {
        LedgerTask<Value> task = tasks.get(e.task());
        yield task != null && allows(e, task);
      }
    };
  }

  private boolean allows(OfClaim entry, LedgerTask<Value> task) {
    return switch (entry) {
      case Claim e -> task.isOpen() && task.claim() + 1 == e.claim() && isPresent(e.who());
      case Begin e -> task.isHeldBy(e.who(), e.claim()) && !task.isBegun();
      case Finish e -> task.isBegunBy(e.who(), e.claim()) && isPresent(e.who());
      case Free e -> !task.isOpen() && !task.isBegun() && task.claim() == e.claim();
      case Reopen e -> task.isBegun() && task.claim() == e.claim();
    };
  }

  private boolean isPresent(ProcessId who) {
    return who.equals(programs.get(who.robot()));
  }

  /** Makes the change, if {@link #allows} it; returns whether it does. */
  boolean apply(LedgerEntry entry) {
    if (!allows(entry)) {
      return false;
    }
    switch (entry) {
      case Start e -> start(e.who());
      case Add e -> {
        added.put(e.task().source(), e.task().number());
        tasks.put(e.task(), new LedgerTask<>(e.task(), e.what(), 0, null, false));
      }
      case Claim e -> tasks.computeIfPresent(e.task(), (id, task) -> task.claimedBy(e.who()));
      case Begin e -> tasks.computeIfPresent(e.task(), (id, task) -> task.begun());
      case Finish e -> tasks.remove(e.task());
      case Free e -> tasks.computeIfPresent(e.task(), (id, task) -> task.open());
      case Reopen e -> tasks.computeIfPresent(e.task(), (id, task) -> task.open());
    }
    return true;
  }

  private void start(ProcessId who) {
    programs.put(who.robot(), who);
    for (Map.Entry<TaskId, LedgerTask<Value>> each : tasks.entrySet()) {
      LedgerTask<Value> task = each.getValue();
      ProcessId holder = task.holder();
      if (holder != null && holder.robot().equals(who.robot()) && !task.isBegun()) {
        each.setValue(task.open());
      }
    }
  }

  /** What this log tells about a change that a robot wants. */
  LedgerOutcome outcome(LedgerEntry entry) {
    if (allows(entry)) {
      return LedgerOutcome.PENDING;
    }
    return switch (entry) {
      case Start e -> LedgerOutcome.DONE;
      case Add e -> {
        LedgerTask<Value> task = tasks.get(e.task());
        boolean isOther = task != null && !task.what().equals(e.what());
        yield isKnown(e.task()) ? doneIf(!isOther) : LedgerOutcome.PENDING;
      }
      case OfClaim e -> {
        LedgerTask<Value> task = tasks.get(e.task());
        yield task != null
            ? outcome(e, task)
            : doneIf(isKnown(e.task()) && (e instanceof Finish || e instanceof Free));
      }
    };
  }

  /** Of a change that the log does not allow now. A robot that is not ready must wait. */
  private LedgerOutcome outcome(OfClaim entry, LedgerTask<Value> task) {
    return switch (entry) {
      case Claim e ->
          task.isOpen() && task.claim() + 1 == e.claim()
              ? LedgerOutcome.PENDING
              : doneIf(task.isHeldBy(e.who(), e.claim()));
      case Begin e -> doneIf(task.isBegunBy(e.who(), e.claim()));
      case Finish e ->
          task.isBegunBy(e.who(), e.claim()) ? LedgerOutcome.PENDING : LedgerOutcome.LATE;
      case Free e -> doneIf(!(task.isBegun() && task.claim() == e.claim()));
      case Reopen e -> doneIf(task.isOpen() || task.claim() > e.claim());
    };
  }

  private boolean isKnown(TaskId task) {
    return task.number() <= added(task.source());
  }

  private static LedgerOutcome doneIf(boolean isDone) {
    return isDone ? LedgerOutcome.DONE : LedgerOutcome.LATE;
  }
}
