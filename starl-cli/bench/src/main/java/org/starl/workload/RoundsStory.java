package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;

/** Counts each {@link Client}'s successful and failed requests, its waits, and the faults. */
final class RoundsStory implements Story {

  private final SortedMap<RobotId, Results> robots = new TreeMap<>();
  private final SortedMap<String, Long> faults = new TreeMap<>();
  private final List<Long> servedNs = new ArrayList<>();
  private int finished;
  private long messages;

  private static final class Results {
    private final List<Long> waitsNs = new ArrayList<>();
    private long askedNs = -1;
    private int failures;
    private int crashes;
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case Action action when action.fact() instanceof ClientFact fact -> addAction(action, fact);
      case Fault fault when fault.name().equals(Fault.CRASH) -> robot(fault.robot()).crashes++;
      case Fault fault when fault.name().equals(Fault.BEGIN) ->
          faults.merge(fault.effect(), 1L, Long::sum);
      default -> {
        // Not part of the story.
      }
    }
  }

  private void addAction(Action action, ClientFact fact) {
    Results robot = robot(action.robot());
    switch (fact) {
      case ClientFact.ask made -> robot.askedNs = action.timeNs();
      case ClientFact.served granted -> {
        servedNs.add(action.timeNs());
        robot.waitsNs.add(action.timeNs() - robot.askedNs);
      }
      case ClientFact.told refused -> robot.failures++;
      case ClientFact.late waking -> {
        // ServiceSpec judges it.
      }
    }
  }

  private Results robot(RobotId id) {
    return robots.computeIfAbsent(id, any -> new Results());
  }

  @Override
  public void finished(SimResult result) {
    finished = result.results().size();
    messages = result.network().sent();
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    robots.forEach((id, robot) -> lines.add(id + " was served " + text(robot)));
    if (!faults.isEmpty()) {
      List<String> kinds = new ArrayList<>();
      faults.forEach((kind, times) -> kinds.add(times + " " + kind));
      lines.add("faults: " + String.join(", ", kinds));
    }
    return lines;
  }

  private static String text(Results robot) {
    String text = robot.waitsNs.size() + " times";
    if (!robot.waitsNs.isEmpty()) {
      long[] sortedNs = robot.waitsNs.stream().mapToLong(Long::longValue).sorted().toArray();
      double medianS = Time.seconds(Measures.waitNs(sortedNs, 50));
      double mostS = Time.seconds(Measures.waitNs(sortedNs, 100));
      text +=
          String.format(Locale.ROOT, ", waited %.2f s (median), %.2f s at most", medianS, mostS);
    }
    return text
        + (robot.failures > 0 ? ", failed " + robot.failures + " times" : "")
        + (robot.crashes > 0 ? ", crashed " + robot.crashes + " times" : "");
  }

  @Override
  public Measures measures() {
    List<Long> waitsNs = new ArrayList<>();
    robots.values().forEach(robot -> waitsNs.addAll(robot.waitsNs));
    SortedMap<String, Long> counts = new TreeMap<>();
    counts.put("rounds", (long) waitsNs.size());
    counts.put(
        "rounds told failed", robots.values().stream().mapToLong(robot -> robot.failures).sum());
    counts.put("messages", messages);
    counts.put("crashes", robots.values().stream().mapToLong(robot -> robot.crashes).sum());
    faults.forEach((kind, times) -> counts.put("faults: " + kind, times));
    return new Measures(robots.size(), finished, waitsNs, new TreeMap<>(), counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("wait for being served", measures().waitsNs()),
        Sample.when("rounds served", servedNs));
  }
}
