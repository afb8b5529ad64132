package org.starl.deployment;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.deployment.MeasuredBodies.Deviation;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.processes.Merged;
import org.starl.sim.Blueprint;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.net.NetStatistics;
import org.starl.sim.world.Collisions;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceHeader;

/**
 * The traces of a deployment's processes as one, judged by the specifications of its app. Where clocks
 * are uncertain, several orders are possible, and where bodies were measured, several places: what is
 * violated in some of them and not in all that are tried, is possible and no more.
 */
public final class Merge {

  private final List<RobotTrace> traces;
  private final ClockBounds bounds;
  private final MeasuredBodies bodies;

  /**
   * What was found.
   *
   * @param run of the middle order
   * @param robots that left traces
   * @param dead robots whose last trace is cut off
   * @param orders how many were tried
   * @param uncertaintyNs how far clocks may be from what the middle order takes them for
   * @param withinMm how far bodies may be from where they were measured; 0 if none was
   * @param lostMs the longest time for which each robot was not measured that was lost at all
   * @param violations whatever clocks and bodies are taken for, as the middle order has them
   * @param possible what is violated in some way that was tried, and not in all
   */
  public record Result(
      SimResult run,
      Set<RobotId> robots,
      Set<RobotId> dead,
      int orders,
      long uncertaintyNs,
      double withinMm,
      SortedMap<RobotId, Double> lostMs,
      List<Violation> violations,
      List<Violation> possible) {}

  private Merge(List<RobotTrace> traces, ClockBounds bounds) {
    this.traces = traces;
    this.bounds = bounds;
    bodies = new MeasuredBodies(traces);
  }

  /**
   * Reads traces.
   *
   * @param dateErrorNs a machine's date is off by so much at most
   * @param driftPpm clocks drift apart by so many parts in a million at most
   * @throws BadInput if one cannot be read, they are not of one deployment, or clocks contradict
   */
  public static Merge of(List<String> files, long dateErrorNs, long driftPpm) {
    List<RobotTrace> traces = new ArrayList<>();
    for (String file : files) {
      RobotTrace trace = RobotTrace.read(file);
      for (RobotTrace before : traces) {
        if (!isOfOneRun(trace.header(), before.header())) {
          throw new BadInput(file + ":1: its header is another; expected that of " + before.file());
        }
      }
      traces.add(trace);
    }
    return new Merge(traces, new ClockBounds(traces, dateErrorNs, driftPpm));
  }

  /** A phone says of the settings those alone that its deployment says. */
  private static boolean isOfOneRun(TraceHeader a, TraceHeader b) {
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

  /** What all of them were a run of. */
  public TraceHeader header() {
    return traces.get(0).header();
  }

  /**
   * Judges them.
   *
   * @param blueprint of the same run
   * @param observers see the middle order, as a run of the simulator
   */
  public Result judge(Blueprint blueprint, List<SimObserver> observers) {
    List<long[]> ways = bounds.ways(traces);
    List<SpecReport> reports = new ArrayList<>();
    Merged middle = new Merged();
    long endNs = 0;
    for (int i = 0; i < ways.size(); i++) {
      Merged merged = i == 0 ? middle : new Merged();
      long wayEndNs = fill(merged, ways.get(i), Deviation.NONE);
      endNs = i == 0 ? wayEndNs : endNs;
      reports.add(merged.show(blueprint, i == 0 ? observers : List.of(), wayEndNs));
    }
    for (Deviation deviation : bodies.deviations()) {
      Merged merged = new Merged();
      long deviationEndNs = fill(merged, ways.get(0), deviation);
      reports.add(merged.show(blueprint, List.of(), deviationEndNs));
    }
    SimResult run = result(middle, endNs, reports.get(0));
    observers.forEach(observer -> observer.finished(run));
    return new Result(
        run,
        robots(),
        dead(),
        ways.size(),
        bounds.uncertaintyNs(),
        bodies.withinMm(),
        bodies.lostMs(),
        certain(reports),
        possible(reports));
  }

  private SimResult result(Merged merged, long endNs, SpecReport report) {
    return new SimResult(
        header().scenarioSeed(),
        header().behaviourSeed(),
        endNs,
        merged.size(),
        new TreeMap<>(),
        List.of(),
        new NetStatistics(merged.datagrams(), merged.bytes(), 0, 0),
        Collisions.NONE,
        report);
  }

  /** Puts everything in the order of one way; when it ends. */
  private long fill(Merged merged, long[] starts, Deviation deviation) {
    Causes causes = new Causes();
    long endNs = 0;
    for (int i = 0; i < starts.length; i++) {
      RobotTrace trace = traces.get(i);
      List<TraceEvent> events = bodies.of(trace, deviation);
      if (isDead(trace)) {
        events.add(new Fault(trace.lastNs(), trace.who(), Fault.CRASH, ""));
      }
      causes.add(events, starts[i]);
      endNs = Math.max(endNs, starts[i] + trace.lastNs());
    }
    for (TraceEvent event : causes.inOrder()) {
      merged.add(event);
      endNs = Math.max(endNs, event.timeNs());
    }
    return endNs;
  }

  /** Whether its process was killed, and this robot's program did not start again. */
  private boolean isDead(RobotTrace trace) {
    if (trace.isWhole() || trace.isOfWorld()) {
      return false;
    }
    return traces.stream()
        .noneMatch(other -> other.who().equals(trace.who()) && other.dateNs() > trace.dateNs());
  }

  private Set<RobotId> robots() {
    Set<RobotId> robots = new TreeSet<>();
    for (RobotTrace trace : traces) {
      if (!trace.isOfWorld()) {
        robots.add(trace.who());
      }
    }
    return robots;
  }

  private Set<RobotId> dead() {
    Set<RobotId> dead = new TreeSet<>();
    for (RobotTrace trace : traces) {
      if (isDead(trace)) {
        dead.add(trace.who());
      }
    }
    return dead;
  }

  private static String what(Violation violation) {
    return violation.lemma() + " " + violation.robots();
  }

  private static Set<String> whats(SpecReport report) {
    Set<String> whats = new TreeSet<>();
    report.violations().forEach(violation -> whats.add(what(violation)));
    return whats;
  }

  private static List<Violation> certain(List<SpecReport> reports) {
    return reports.get(0).violations().stream()
        .filter(violation ->
            reports.stream().allMatch(report -> whats(report).contains(what(violation))))
        .toList();
  }

  private static List<Violation> possible(List<SpecReport> reports) {
    Set<String> seen = new TreeSet<>();
    certain(reports).forEach(violation -> seen.add(what(violation)));
    List<Violation> possible = new ArrayList<>();
    for (SpecReport report : reports) {
      for (Violation violation : report.violations()) {
        if (seen.add(what(violation))) {
          possible.add(violation);
        }
      }
    }
    return possible;
  }
}
