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
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;

/** How often each {@link Client} was served, how long it waited, and the faults. */
final class RoundsStory implements Story {

  private static final double NS_PER_S = 1e9;

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
      case Action action when action.source().equals(Client.SOURCE) -> addAction(action);
      case Fault fault -> addFault(fault);
      default -> {
        // Not part of the story.
      }
    }
  }

  private void addAction(Action action) {
    Results robot = robot(action.robot());
    switch (action.name()) {
      case Client.ASK -> robot.askedNs = action.timeNs();
      case Client.SERVED -> {
        servedNs.add(action.timeNs());
        robot.waitsNs.add(action.timeNs() - robot.askedNs);
      }
      case Client.TOLD -> robot.failures++;
      default -> throw new IllegalStateException("unknown action " + action.name());
    }
  }

  private void addFault(Fault fault) {
    switch (fault.name()) {
      case Fault.CRASH -> robot(fault.robot()).crashes++;
      case Fault.BEGIN -> count(fault.detail().split("\\(", 2)[0]);
      default -> {
        // Only the beginning of a fault is counted.
      }
    }
  }

  private void count(String kind) {
    faults.merge(kind, 1L, Long::sum);
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
    robots.forEach((id, robot) -> lines.add(line(id, robot)));
    if (!faults.isEmpty()) {
      List<String> kinds = new ArrayList<>();
      faults.forEach((kind, times) -> kinds.add(times + " " + kind));
      lines.add("faults: " + String.join(", ", kinds));
    }
    return lines;
  }

  private static String line(RobotId id, Results robot) {
    StringBuilder line = new StringBuilder(id + " was served ");
    line.append(robot.waitsNs.size()).append(" times");
    if (!robot.waitsNs.isEmpty()) {
      long[] sortedNs = robot.waitsNs.stream().mapToLong(Long::longValue).sorted().toArray();
      line.append(", waited ").append(seconds(Measures.waitNs(sortedNs, 50)));
      line.append(" (median), ").append(seconds(Measures.waitNs(sortedNs, 100)));
      line.append(" at most");
    }
    if (robot.failures > 0) {
      line.append(", failed ").append(robot.failures).append(" times");
    }
    if (robot.crashes > 0) {
      line.append(", crashed ").append(robot.crashes).append(" times");
    }
    return line.toString();
  }

  private static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.2f s", ns / NS_PER_S);
  }

  @Override
  public Measures measures() {
    List<Long> waitsNs = new ArrayList<>();
    long failures = 0;
    long crashes = 0;
    for (Results robot : robots.values()) {
      waitsNs.addAll(robot.waitsNs);
      failures += robot.failures;
      crashes += robot.crashes;
    }
    SortedMap<String, Long> counts = new TreeMap<>();
    counts.put("rounds", (long) waitsNs.size());
    counts.put("rounds told failed", failures);
    counts.put("messages", messages);
    counts.put("crashes", crashes);
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
