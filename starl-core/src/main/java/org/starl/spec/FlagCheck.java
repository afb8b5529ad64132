package org.starl.spec;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

/**
 * Checks that a variable which apps read says what the facts say. An event allows
 * some values. Each later value must be one of them, and the present one must be before the robot's program
 * does anything at a later time: a piece of a strand has one time, and sets the variable after the fact.
 */
public final class FlagCheck<T> {

  /** The variable of one start of a robot's program. */
  private static final class Flag<T> {
    private final ProcessKey key;
    private @Nullable T value;
    // Null before the first value: it may be any, and stays until an event allows another.
    private @Nullable Predicate<? super T> allowed;
    private String since = "the start";
    private long lateSinceNs;

    Flag(ProcessKey key) {
      this.key = key;
    }

    boolean isOf(TraceEvent event) {
      return key.robot().equals(event.robot());
    }
  }

  private final Var<T> variable;
  private final String lemma;
  private final Map<ProcessKey, Flag<T>> flags = new LinkedHashMap<>();
  // Those whose value is not allowed.
  private final Set<Flag<T>> late = new LinkedHashSet<>();

  public FlagCheck(Var<T> variable, String lemma) {
    this.variable = variable;
    this.lemma = lemma;
  }

  /** Processes every event, before the other methods. */
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Left left -> forget(left);
      case Fault fault when fault.name().equals(Fault.CRASH) -> forget(fault);
      case Moved moved -> {
        // The body's, not the program's.
      }
      default -> expire(event, report);
    }
  }

  private void forget(TraceEvent end) {
    flags.values().removeIf(flag -> flag.isOf(end));
    late.removeIf(flag -> flag.isOf(end));
  }

  private void expire(TraceEvent event, Report report) {
    late.removeIf(flag -> {
      boolean isOver = flag.isOf(event) && flag.lateSinceNs < event.timeNs();
      if (isOver) {
        violated(flag, flag.lateSinceNs, report);
      }
      return isOver;
    });
  }

  /** From this event on, the variable has one of the allowed values. */
  public void says(ProcessKey key, TraceEvent event, Predicate<? super T> allowed, Report report) {
    Flag<T> flag = flags.computeIfAbsent(key, Flag::new);
    flag.allowed = allowed;
    if (event instanceof Action action) {
      flag.since = action.name();
    } else if (event instanceof Variable other && other.variable() != variable) {
      flag.since = other.name();
    }
    T value = flag.value;
    if (value == null) {
      return;
    }
    if (!allowed.test(value)) {
      flag.lateSinceNs = event.timeNs();
      late.add(flag);
    } else if (late.remove(flag) || event instanceof Action) {
      report.checked(lemma);
    }
  }

  /** Passes a new value, if {@code event} is one of this variable. */
  public void shows(Variable event, Report report) {
    T value = event.of(variable);
    if (value == null) {
      return;
    }
    ProcessKey key = new ProcessKey(event.source(), event.robot());
    Flag<T> flag = flags.computeIfAbsent(key, Flag::new);
    flag.value = value;
    boolean wasLate = late.remove(flag);
    if (flag.allowed == null) {
      flag.allowed = value::equals;
    } else if (!flag.allowed.test(value)) {
      violated(flag, event.timeNs(), report);
    } else if (wasLate) {
      report.checked(lemma);
    }
  }

  private void violated(Flag<T> flag, long timeNs, Report report) {
    report.checked(lemma);
    String detail =
        flag.key.source() + ": " + variable.name() + " is " + flag.value + " after " + flag.since;
    report.violated(lemma, timeNs, List.of(flag.key.robot()), detail);
  }
}
