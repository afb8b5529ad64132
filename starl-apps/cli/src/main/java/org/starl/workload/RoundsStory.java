package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.sim.check.Percentile;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;

/** How {@link Client}s fared: who asked how often, waited how long, and what befell them. */
final class RoundsStory implements Story {

  private static final double NS_PER_S = 1e9;
  private static final int HALF = 50;
  private static final int MOST = 100;

  private final SortedMap<RobotId, Fared> robots = new TreeMap<>();
  private final SortedMap<String, Long> faults = new TreeMap<>();
  private final List<Long> servedNs = new ArrayList<>();
  private int finished;
  private long messages;

  private static final class Fared {
    private final List<Long> waitsNs = new ArrayList<>();
    private long askedNs = -1;
    private int told;
    private int crashes;
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case Action action when action.source().equals(Client.SOURCE) -> acted(action);
      case Fault fault -> befell(fault);
      default -> {
        // No part of the story.
      }
    }
  }

  private void acted(Action action) {
    Fared robot = robot(action.robot());
    switch (action.name()) {
      case Client.ASK -> robot.askedNs = action.timeNs();
      case Client.SERVED -> {
        servedNs.add(action.timeNs());
        robot.waitsNs.add(action.timeNs() - robot.askedNs);
      }
      case Client.TOLD -> robot.told++;
      default -> throw new IllegalStateException("a client does not " + action.name());
    }
  }

  private void befell(Fault fault) {
    switch (fault.name()) {
      case Fault.CRASH -> robot(fault.robot()).crashes++;
      case Fault.BEGIN -> count(fault.detail().split("\\(", 2)[0]);
      default -> {
        // Its beginning is counted.
      }
    }
  }

  private void count(String kind) {
    faults.merge(kind, 1L, Long::sum);
  }

  private Fared robot(RobotId id) {
    return robots.computeIfAbsent(id, any -> new Fared());
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

  private static String line(RobotId id, Fared robot) {
    StringBuilder line = new StringBuilder(id + " was served ");
    line.append(robot.waitsNs.size()).append(" times");
    if (!robot.waitsNs.isEmpty()) {
      line.append(", waited ").append(seconds(percentile(robot.waitsNs, HALF)));
      line.append(" as a rule, ").append(seconds(percentile(robot.waitsNs, MOST)));
      line.append(" at most");
    }
    if (robot.told > 0) {
      line.append(", was told ").append(robot.told).append(" times that it would not be");
    }
    if (robot.crashes > 0) {
      line.append(", crashed ").append(robot.crashes).append(" times");
    }
    return line.toString();
  }

  private static long percentile(List<Long> values, int percent) {
    List<Long> sorted = new ArrayList<>(values);
    sorted.sort(Long::compare);
    return sorted.get(Percentile.index(sorted.size(), percent));
  }

  private static String seconds(long ns) {
    long hundredths = Math.round(ns / NS_PER_S * 100);
    return hundredths / 100 + (hundredths % 100 < 10 ? ".0" : ".") + hundredths % 100 + " s";
  }

  @Override
  public Measures measures() {
    List<Long> waitsNs = new ArrayList<>();
    long told = 0;
    long crashes = 0;
    for (Fared robot : robots.values()) {
      waitsNs.addAll(robot.waitsNs);
      told += robot.told;
      crashes += robot.crashes;
    }
    SortedMap<String, Long> counts = new TreeMap<>();
    counts.put("rounds", (long) waitsNs.size());
    counts.put("rounds told failed", told);
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
