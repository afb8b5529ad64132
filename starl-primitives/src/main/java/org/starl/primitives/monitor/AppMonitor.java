package org.starl.primitives.monitor;

import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.barrier.BarrierTrace;
import org.starl.primitives.election.ElectionTrace;
import org.starl.primitives.election.Leader;
import org.starl.primitives.membership.View;
import org.starl.primitives.motion.MotionTrace;
import org.starl.primitives.mutex.MutexEvent;
import org.starl.primitives.mutex.MutexTrace;
import org.starl.primitives.registration.RegistrationTrace;
import org.starl.spec.Bodies;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

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

  private static final String APP = "app";

  private final Bodies bodies = new Bodies();
  private long nowNs;
  private @Nullable Report report;

  /** An app's variable has a new value. */
  protected void onVariable(RobotId robot, String name, String value) {}

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
          "check("
              + lemma
              + "): expected one of "
              + lemmas()
              + "; the constructor calls lemma(...)");
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
      case Action action -> MutexTrace.read(action).ifPresent(e -> mutex(robot, action, e));
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

  private void mutex(RobotId robot, Action action, MutexEvent event) {
    String mutex = instance(action.source());
    switch (event) {
      case MutexEvent.DoMutex request -> onRequested(robot, mutex, request.want());
      case MutexEvent.OdMutex access -> onGranted(robot, mutex, access.held());
      case MutexEvent.Release release -> onReleased(robot, mutex, release.left());
      default -> {}
    }
  }

  private void changed(RobotId robot, Variable variable) {
    String value = variable.value();
    String instance = instance(variable.source());
    if (variable.source().equals(APP)) {
      onVariable(robot, variable.name(), value);
    } else if (MotionTrace.isFlag(variable)) {
      onMotion(robot, MotionFlag.valueOf(value));
    } else if (is(variable, ElectionTrace.PRIMITIVE, ElectionTrace.LEADER)) {
      onLeader(robot, instance, Leader.parse(value));
    } else if (is(variable, BarrierTrace.PRIMITIVE, BarrierTrace.OUTCOME)) {
      onOutcome(robot, instance, BarrierOutcome.parse(value));
    } else if (is(variable, RegistrationTrace.PRIMITIVE, RegistrationTrace.VIEW)) {
      onView(robot, instance, View.parse(value));
    } else if (is(variable, SetAgreement.PRIMITIVE, SetAgreement.DECIDED)) {
      onDecided(robot, instance, value);
    }
  }

  private static boolean is(Variable variable, String primitive, String name) {
    return variable.name().equals(name) && variable.source().startsWith(primitive + "/");
  }

  private static String instance(String source) {
    return source.substring(source.indexOf('/') + 1);
  }
}
