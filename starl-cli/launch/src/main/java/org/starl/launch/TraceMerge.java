package org.starl.launch;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.launch.MeasuredBodies.Deviation;
import org.starl.sim.Diagnosis;
import org.starl.sim.Failure;
import org.starl.sim.RunObservers;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimulationPlan;
import org.starl.sim.net.NetStatistics;
import org.starl.sim.world.Collisions;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.TraceHeader;
import org.starl.trace.Vocabulary;

/**
 * Merges the traces of several processes into one trace and checks the app's specifications.
 * Uncertain clocks allow several orders of events, and measured bodies several positions. A violation
 * in all tried cases is certain; a violation in only some of them is possible.
 *
 * <p>Progress is not required: the merged trace begins with a fault of the world that never ends,
 * because a machine with other work guarantees no times. Safety is checked exactly.
 */
public final class TraceMerge {

  private final List<RecordedTrace> traces;
  private final ClockBounds bounds;
  private final MeasuredBodies bodies;

  /**
   * The verdict.
   *
   * @param run of the middle order
   * @param robots that left traces
   * @param dead robots whose last trace is cut off
   * @param orders number of tried orders
   * @param uncertaintyNs the largest error of the clocks in the middle order
   * @param withinMm the largest distance of a body from its measured place; 0 if none was measured
   * @param lostMs for each robot with a gap in its measurements, the longest gap
   * @param missing a line for each start of a robot whose trace is missing
   * @param violations in all cases, as the middle order has them; none if a start is missing, because
   *     the robot's promises in it are unknown
   * @param possible violations in some cases only
   */
  public record Result(
      SimResult run,
      Set<RobotId> robots,
      Set<RobotId> dead,
      int orders,
      long uncertaintyNs,
      double withinMm,
      SortedMap<RobotId, Double> lostMs,
      List<String> missing,
      List<Violation> violations,
      List<Violation> possible) {

    /** The lemmas with a violation that is possible, and none that is certain. */
    public SortedSet<String> undecided() {
      SortedSet<String> lemmas =
          possible.stream().map(Violation::lemma).collect(Collectors.toCollection(TreeSet::new));
      violations.forEach(violation -> lemmas.remove(violation.lemma()));
      return lemmas;
    }

    /** What went wrong; null if it is not certain that anything did. */
    public @Nullable Failure failure() {
      return violations.isEmpty() ? null : run.failure();
    }
  }

  /** One order of all events. */
  private record Case(List<TraceEvent> events, long endNs) {}

  /** Traces of one run on machines whose clocks differ by at most this. */
  TraceMerge(List<RecordedTrace> traces, long dateErrorNs, long driftPpm) {
    this.traces = List.copyOf(traces);
    bounds = new ClockBounds(traces, dateErrorNs, driftPpm);
    bodies = new MeasuredBodies(traces);
  }

  /**
   * Reads traces.
   *
   * @param vocabularyOf the shapes of the values in a trace with this header
   * @param dateErrorNs the largest error of a machine's date
   * @param driftPpm the largest drift between two clocks, in parts per million
   * @throws BadInput if one cannot be read, they are not of one deployment, or clocks contradict
   */
  public static TraceMerge of(
      List<String> files,
      Function<TraceHeader, Vocabulary> vocabularyOf,
      long dateErrorNs,
      long driftPpm) {
    List<RecordedTrace> traces = new ArrayList<>();
    for (String file : files) {
      RecordedTrace trace = RecordedTrace.read(file, vocabularyOf);
      for (RecordedTrace before : traces) {
        if (trace.isSameStart(before)) {
          throw new BadInput(
              "%s: the same start of %s as %s; give one"
                  .formatted(file, trace.robot(), before.name()));
        }
        if (!isOfOneRun(trace.header(), before.header())) {
          throw new BadInput(
              file + ":1: its header differs; expected the header of " + before.name());
        }
      }
      traces.add(trace);
    }
    return new TraceMerge(traces, dateErrorNs, driftPpm);
  }

  /** A phone writes only those settings that its deployment file has: compare the common ones. */
  static boolean isOfOneRun(TraceHeader a, TraceHeader b) {
    for (String setting : a.settings().keySet()) {
      String other = b.settings().get(setting);
      if (other != null && !other.equals(a.settings().get(setting))) {
        return false;
      }
    }
    return a.starl().equals(b.starl())
        && a.scenario().equals(b.scenario())
        && a.scenarioSeed() == b.scenarioSeed()
        && a.behaviourSeed() == b.behaviourSeed()
        && a.robots().equals(b.robots());
  }

  /** The header of the first trace. */
  public TraceHeader header() {
    return traces.get(0).header();
  }

  /**
   * Judges the traces.
   *
   * @param plan of the same run
   * @param observers see the middle order like a simulated run
   */
  public Result judge(SimulationPlan plan, List<SimObserver> observers) {
    return judge(plan, observers, run -> run);
  }

  /** The same; {@code complete} adds results that the traces do not have. */
  Result judge(
      SimulationPlan plan, List<SimObserver> observers, UnaryOperator<SimResult> complete) {
    List<long[]> clocks = bounds.candidates(traces);
    Case middle = order(clocks.get(0), Deviation.NONE);
    List<SpecReport> reports = new ArrayList<>();
    RunObservers shown =
        new RunObservers(
            Monitors.of(plan.monitors()), observers, violation -> Diagnosis.NONE, plan.commands());
    reports.add(show(middle, plan, shown));
    for (long[] starts : clocks.subList(1, clocks.size())) {
      reports.add(judge(order(starts, Deviation.NONE), plan));
    }
    for (Deviation deviation : bodies.deviations()) {
      reports.add(judge(order(clocks.get(0), deviation), plan));
    }
    SimResult run = described(complete.apply(result(middle, reports.get(0))), shown);
    shown.finished(run);
    List<String> missing = missingStarts();
    List<Violation> certain = missing.isEmpty() ? certain(reports) : List.of();
    return new Result(
        run,
        robots(traces.stream().filter(trace -> !trace.isOfWorld()).toList()),
        robots(traces.stream().filter(this::isDead).toList()),
        clocks.size(),
        bounds.uncertaintyNs(),
        bodies.withinMm(),
        bodies.lostMs(),
        missing,
        certain,
        possible(reports, certain));
  }

  private List<String> missingStarts() {
    List<String> missing = new ArrayList<>();
    for (RecordedTrace trace : traces) {
      int before = trace.start() - 1;
      boolean isThere =
          traces.stream()
              .anyMatch(other -> other.robot().equals(trace.robot()) && other.start() == before);
      if (before > 0 && !isThere) {
        missing.add(
            trace.name()
                + ": start "
                + trace.start()
                + " of "
                + trace.robot()
                + " without its start "
                + before
                + ", so what it promised before is unknown; give all its traces");
      }
    }
    return missing;
  }

  /** All events, for traces that start at these times. Actions of one instant stay together. */
  private Case order(long[] starts, Deviation deviation) {
    CausalOrder order = new CausalOrder();
    order.add(List.of(Fault.realTime(0)), 0);
    long endNs = 0;
    for (int i = 0; i < starts.length; i++) {
      RecordedTrace trace = traces.get(i);
      List<TraceEvent> events = bodies.events(trace, deviation);
      if (isDead(trace)) {
        events.add(new Fault(trace.lastNs(), trace.robot(), Fault.CRASH, ""));
      }
      order.add(events, starts[i]);
      endNs = Math.max(endNs, starts[i] + trace.lastNs());
    }
    List<TraceEvent> events = order.inOrder();
    events.sort(Comparator.comparingLong(TraceEvent::timeNs).thenComparing(TraceEvent::robot));
    return new Case(believing(events), Math.max(endNs, events.get(events.size() - 1).timeNs()));
  }

  /** With what the robots believed as deviations from their true poses. */
  private static List<TraceEvent> believing(List<TraceEvent> events) {
    Beliefs beliefs = new Beliefs();
    List<TraceEvent> all = new ArrayList<>();
    for (TraceEvent event : events) {
      var fromOrigin =
          event instanceof Variable variable ? variable.of(org.starl.motion.Deviation.VAR) : null;
      if (fromOrigin == null) {
        beliefs.observe(event);
        all.add(event);
      } else {
        Pose measured = new Pose(fromOrigin.xMm(), fromOrigin.yMm(), fromOrigin.headingRad());
        Variable belief = beliefs.of(event.robot(), measured, event.timeNs());
        if (belief != null) {
          all.add(belief);
        }
      }
    }
    return all;
  }

  private static SpecReport show(Case shown, SimulationPlan plan, RunObservers observers) {
    observers.started(plan.header());
    shown.events().forEach(observers::record);
    return observers.endSpecifications(shown.endNs());
  }

  private static SpecReport judge(Case shown, SimulationPlan plan) {
    Monitors monitors = Monitors.of(plan.monitors());
    shown.events().forEach(monitors::observe);
    monitors.finish(shown.endNs());
    return monitors.report();
  }

  /** With its faults, and what went wrong. */
  private static SimResult described(SimResult run, RunObservers observers) {
    return new SimResult(
        run.seed(),
        run.behaviourSeed(),
        run.endNs(),
        run.events(),
        run.results(),
        run.unfinished(),
        run.network(),
        run.collisions(),
        run.spec(),
        run.diagnosis(),
        run.diagnoses(),
        observers.faults(),
        observers.failure(run.unfinished(), run.diagnosis(), run.endNs()));
  }

  private SimResult result(Case middle, SpecReport report) {
    List<Sent> sent =
        middle.events().stream().filter(Sent.class::isInstance).map(Sent.class::cast).toList();
    long bytes = sent.stream().mapToLong(Sent::bytes).sum();
    return new SimResult(
        header().scenarioSeed(),
        header().behaviourSeed(),
        middle.endNs(),
        middle.events().size(),
        new TreeMap<>(),
        List.of(),
        new NetStatistics(sent.size(), bytes, 0, 0),
        Collisions.NONE,
        report);
  }

  /** Whether its process was killed, and this robot's program was not started again. */
  private boolean isDead(RecordedTrace trace) {
    return !trace.isComplete()
        && !trace.isOfWorld()
        && traces.stream()
            .noneMatch(
                other -> other.robot().equals(trace.robot()) && other.dateNs() > trace.dateNs());
  }

  private static Set<RobotId> robots(List<RecordedTrace> traces) {
    return traces.stream().map(RecordedTrace::robot).collect(Collectors.toCollection(TreeSet::new));
  }

  /** Identifies a violation: its time and words may differ between orders of events. */
  private static String key(Violation violation) {
    return violation.lemma() + " " + violation.robots();
  }

  /** The violations of the first report that all others have, too. */
  private static List<Violation> certain(List<SpecReport> reports) {
    List<Set<String>> keys =
        reports.stream()
            .map(report ->
                report.violations().stream().map(TraceMerge::key).collect(Collectors.toSet()))
            .toList();
    return reports.get(0).violations().stream()
        .filter(violation -> keys.stream().allMatch(all -> all.contains(key(violation))))
        .toList();
  }

  /** The other violations, one of each kind. */
  private static List<Violation> possible(List<SpecReport> reports, List<Violation> certain) {
    Set<String> seen =
        certain.stream().map(TraceMerge::key).collect(Collectors.toCollection(TreeSet::new));
    return reports.stream()
        .flatMap(report -> report.violations().stream())
        .filter(violation -> seen.add(key(violation)))
        .toList();
  }
}
