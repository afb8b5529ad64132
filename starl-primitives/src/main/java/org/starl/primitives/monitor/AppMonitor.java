package org.starl.primitives.monitor;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.barrier.BarrierFact;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.election.ElectionFact;
import org.starl.primitives.election.Leader;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.registration.RegistrationFact;
import org.starl.spec.Bodies;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

/**
 * A monitor for an app's own specification. Name lemmas in the constructor with {@link #lemma},
 * override the methods for the events that matter, and call {@link #check} there.
 *
 * <pre>{@code
 * final class OneWelder extends AppMonitor {
 *   private final Set<RobotId> welders = new TreeSet<>();
 *
 *   OneWelder() {
 *     lemma("one_welder", "At most one robot welds.");
 *   }
 *
 *   @Override
 *   protected void onGranted(RobotId robot, String mutex, SortedSet<String> sections) {
 *     welders.add(robot);
 *     check("one_welder", welders.size() == 1, welders, "two robots weld");
 *   }
 *
 *   @Override
 *   protected void onReleased(RobotId robot, String mutex, SortedSet<String> left) {
 *     welders.remove(robot);
 *   }
 * }
 * }</pre>
 *
 * <p>Primitives are named by their instance: {@code crossing} for the mutex {@code mutex/crossing}.
 */
public abstract class AppMonitor extends LemmaMonitor {

  private final List<Consumer<Variable>> listeners = new ArrayList<>();
  private final List<Consumer<Action>> facts = new ArrayList<>();
  private final Bodies bodies = new Bodies();
  private long nowNs;
  private @Nullable Report report;

  /**
   * Calls {@code listener} for each new value of an app's variable, the first one included. For
   * constructors: {@code on(ROUNDS, (robot, rounds) -> ...)}.
   */
  protected final <T> void on(Var<T> variable, BiConsumer<RobotId, T> listener) {
    listeners.add(changed -> {
      T value = changed.of(variable);
      if (value != null) {
        listener.accept(changed.robot(), value);
      }
    });
  }

  /**
   * Calls {@code listener} for each fact of this type. For constructors: {@code on(Crate.class, (robot,
   * crate) -> ...)}.
   */
  protected final <F> void on(Class<F> fact, BiConsumer<RobotId, F> listener) {
    facts.add(action -> {
      if (fact.isInstance(action.fact())) {
        listener.accept(action.robot(), fact.cast(action.fact()));
      }
    });
  }

  /** A robot requests sections of a mutex. */
  protected void onRequested(RobotId robot, String mutex, SortedSet<String> sections) {}

  /** A robot holds sections of a mutex from now on. */
  protected void onGranted(RobotId robot, String mutex, SortedSet<String> sections) {}

  /**
   * A robot has released sections of a mutex.
   *
   * @param left the sections that it still holds
   */
  protected void onReleased(RobotId robot, String mutex, SortedSet<String> left) {}

  /** What a robot knows of the leader has changed. */
  protected void onLeader(RobotId robot, String election, Leader leader) {}

  /** What a robot knows of its latest wait at a barrier has changed. */
  protected void onOutcome(RobotId robot, String barrier, BarrierOutcome outcome) {}

  /** A robot has learned of a view of a registration. */
  protected void onView(RobotId robot, String registration, View view) {}

  /** A robot has learned of a decision; equal decisions have equal texts. */
  protected void onDecided(RobotId robot, String agreement, String decision) {}

  /** The {@code motionflag} of a robot has a new value. */
  protected void onMotion(RobotId robot, MotionFlag flag) {}

  /** A robot's body is on the floor from now on. */
  protected void onJoined(RobotId robot) {}

  /** A robot's body has left the floor. */
  protected void onLeft(RobotId robot) {}

  /** A robot's program has crashed. */
  protected void onCrashed(RobotId robot) {}

  /** A robot's program has started again. */
  protected void onRestarted(RobotId robot) {}

  /** The run has ended. */
  protected void onEnd() {}

  /**
   * Reports that a lemma was checked, and a violation if it does not hold. Only in the methods above.
   *
   * @param robots the robots involved
   * @param detail one line with the values, for a violation
   */
  protected final void check(
      String lemma, boolean holds, Collection<RobotId> robots, String detail) {
    Report current = report;
    if (current == null) {
      throw new IllegalStateException("check(" + lemma + ") outside an event");
    }
    if (!lemmas().contains(lemma)) {
      throw new IllegalArgumentException(
          String.format(
              "check(%s): expected one of %s; the constructor calls lemma(...)", lemma, lemmas()));
    }
    current.checked(lemma);
    if (!holds) {
      current.violated(lemma, nowNs, List.copyOf(new TreeSet<>(robots)), detail);
    }
  }

  /** The time of the event, in ns from the start of the run. */
  protected final long nowNs() {
    return nowNs;
  }

  /** The true bodies of all robots; read-only here. */
  protected final Bodies bodies() {
    return bodies;
  }

  @Override
  public final void observe(TraceEvent event, Report newReport) {
    nowNs = event.timeNs();
    report = newReport;
    bodies.observe(event);
    RobotId robot = event.robot();
    switch (event) {
      case Action action -> acted(robot, action);
      case Variable variable -> changed(robot, variable);
      case Joined joined -> onJoined(robot);
      case Left left -> onLeft(robot);
      case Fault fault when fault.name().equals(Fault.CRASH) -> onCrashed(robot);
      case Fault fault when fault.name().equals(Fault.RESTART) -> onRestarted(robot);
      default -> {}
    }
  }

  @Override
  public final void finish(long endNs, Report newReport) {
    nowNs = endNs;
    report = newReport;
    onEnd();
  }

  private void acted(RobotId robot, Action action) {
    String mutex = action.source().xid();
    switch (action.fact()) {
      case MutexFact.DoMutex request -> onRequested(robot, mutex, request.want());
      case MutexFact.OdMutex access -> onGranted(robot, mutex, access.held());
      case MutexFact.Release release -> onReleased(robot, mutex, release.left());
      default -> {}
    }
    facts.forEach(listener -> listener.accept(action));
  }

  private void changed(RobotId robot, Variable variable) {
    listeners.forEach(listener -> listener.accept(variable));
    String instance = variable.source().xid();
    tell(variable.of(MotionFact.FLAG), flag -> onMotion(robot, flag));
    tell(variable.of(ElectionFact.LEADER), leader -> onLeader(robot, instance, leader));
    tell(variable.of(BarrierFact.OUTCOME), outcome -> onOutcome(robot, instance, outcome));
    tell(variable.of(RegistrationFact.VIEW), view -> onView(robot, instance, view));
    tell(
        variable.of(AgreementFact.DECIDED),
        decision -> onDecided(robot, instance, decision.toString()));
  }

  private static <T> void tell(@Nullable T value, Consumer<T> listener) {
    if (value != null) {
      listener.accept(value);
    }
  }
}
