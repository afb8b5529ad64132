package org.starl.sim;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.spec.Bodies;
import org.starl.spec.FaultState;
import org.starl.spec.SpecReport.Violation;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** Describes a failure from the events before it. */
final class FailureFinder {

  private final Bodies bodies = new Bodies();
  private final Map<RobotId, Deviation> deviations = new TreeMap<>();
  private final List<InjectedFault> faults = new ArrayList<>();
  private final Supplier<List<String>> commands;
  // The latest fault that crashes robots: their crashes follow at the same time.
  private @Nullable Fault crash;

  /**
   * @param commands for the failure; asked for when there is one
   */
  FailureFinder(Supplier<List<String>> commands) {
    this.commands = commands;
  }

  /** Processes the next event. */
  void observe(TraceEvent event) {
    bodies.observe(event);
    if (event instanceof Variable variable) {
      Deviation deviation = variable.of(Deviation.VAR);
      if (deviation != null) {
        deviations.put(variable.robot(), deviation);
      }
    } else if (event instanceof Fault fault) {
      note(fault);
    }
  }

  private void note(Fault fault) {
    RobotId robot = fault.robot();
    switch (fault.name()) {
      case Fault.BEGIN -> {
        if (fault.isOfCrashes()) {
          crash = fault;
        } else if (!fault.isRealTime()) {
          begin(robot, false, fault.detail(), fault.timeNs());
        }
      }
      case Fault.CRASH -> {
        deviations.remove(robot); // what it believed is lost
        Fault cause = crash;
        String text =
            cause != null && cause.timeNs() == fault.timeNs() ? cause.detail() : Fault.CRASH;
        begin(robot, true, text, fault.timeNs());
      }
      case Fault.RESTART -> end(robot, InjectedFault::isCrash, fault.timeNs());
      case Fault.END -> {
        if (!fault.isOfCrashes()) {
          end(robot, injected -> injected.text().equals(fault.detail()), fault.timeNs());
        }
      }
      default -> {
        // HEALED ends nothing that has not ended.
      }
    }
  }

  private void begin(RobotId robot, boolean isCrash, String text, long timeNs) {
    faults.add(new InjectedFault(robot, isCrash, text, timeNs, InjectedFault.NOT_ENDED));
  }

  /** Ends the robot's latest fault of this kind. */
  private void end(RobotId robot, Predicate<InjectedFault> kind, long timeNs) {
    for (int i = faults.size() - 1; i >= 0; i--) {
      InjectedFault fault = faults.get(i);
      boolean isActive = fault.endedNs() == InjectedFault.NOT_ENDED;
      if (isActive && fault.robot().equals(robot) && kind.test(fault)) {
        faults.set(i, fault.ended(timeNs));
        return;
      }
    }
  }

  /** The faults so far, in the order of their beginnings. */
  List<InjectedFault> faults() {
    return List.copyOf(faults);
  }

  /**
   * Describes a violation.
   *
   * @param sentence what its lemma says
   */
  Failure violated(Violation violation, String sentence, Diagnosis diagnosis) {
    return failure(
        Failure.Kind.VIOLATED,
        violation.lemma(),
        sentence,
        violation.toString(),
        violation.timeNs(),
        violation.robots(),
        violation.region(),
        diagnosis);
  }

  /** Describes a run that has not finished. */
  Failure unfinished(List<RobotId> robots, Diagnosis diagnosis, long endNs) {
    List<RobotId> culprits = diagnosis.culprits();
    return failure(
        Failure.Kind.UNFINISHED,
        "",
        "",
        "not finished at " + Time.text(endNs, 3) + ": " + Diagnosis.text(robots),
        endNs,
        culprits.isEmpty() ? robots : culprits,
        new Nowhere(),
        diagnosis);
  }

  /** Describes an error that ends the run. */
  Failure failed(List<RobotId> robots, String headline, long atNs) {
    return failure(
        Failure.Kind.FAILED, "", "", headline, atNs, robots, new Nowhere(), Diagnosis.NONE);
  }

  private Failure failure(
      Failure.Kind kind,
      String lemma,
      String sentence,
      String headline,
      long atNs,
      List<RobotId> robots,
      Region region,
      Diagnosis diagnosis) {
    List<Failure.Culprit> culprits = new ArrayList<>();
    for (RobotId robot : robots) {
      culprits.add(
          new Failure.Culprit(
              robot,
              bodies.isOnFloor(robot) ? bodies.poseAt(robot, atNs) : null,
              deviations.getOrDefault(robot, Deviation.NONE)));
    }
    List<InjectedFault> begun = new ArrayList<>(faults);
    begun.removeIf(fault -> fault.beganNs() > atNs);
    begun.sort(Comparator.comparing(fault -> !robots.contains(fault.robot())));
    return new Failure(
        kind,
        lemma,
        sentence,
        headline,
        atNs,
        culprits,
        region,
        begun,
        cause(culprits, begun, atNs, diagnosis),
        commands.get());
  }

  /** What culprits believed wrongly, why robots wait, and the faults that may be the reason. */
  private static String cause(
      List<Failure.Culprit> culprits, List<InjectedFault> faults, long atNs, Diagnosis diagnosis) {
    List<String> parts = new ArrayList<>();
    for (Failure.Culprit culprit : culprits) {
      if (culprit.deviation().isFalse()) {
        parts.add(
            "%s believed to be %d mm from where it was"
                .formatted(culprit.robot(), StrictMath.round(culprit.deviation().distanceMm())));
      }
    }
    if (!diagnosis.cause().isEmpty()) {
      parts.add(diagnosis.cause());
    }
    List<RobotId> robots = culprits.stream().map(Failure.Culprit::robot).toList();
    List<InjectedFault> recent =
        faults.stream().filter(fault -> fault.isRecent(atNs, FaultState.SETTLE_NS)).toList();
    List<InjectedFault> own =
        recent.stream().filter(fault -> robots.contains(fault.robot())).toList();
    List<InjectedFault> likely = own.isEmpty() ? recent : own;
    if (!likely.isEmpty()) {
      parts.add("after " + likely.getLast());
    }
    return String.join("; ", parts);
  }
}
