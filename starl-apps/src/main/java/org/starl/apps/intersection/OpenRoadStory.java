package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.apps.intersection.logic.Zone;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** How the traffic went. Of a car that has left, only how long it waited and when it left is kept. */
final class OpenRoadStory implements Story {

  private static final double NS_PER_S = 1e9;
  private static final double NS_PER_MIN = 60e9;

  private final long untilNs;
  private final SortedMap<RobotId, Arrival> waiting = new TreeMap<>();
  private final Set<RobotId> onFloor = new TreeSet<>();
  private final Map<Zone, Integer> queues = new EnumMap<>(Zone.class);
  private final Map<Zone, Integer> beyondEdge = new EnumMap<>(Zone.class);
  private final List<Long> waitsNs = new ArrayList<>();
  private final List<Long> leftNs = new ArrayList<>();
  private int arrived;
  private int cameIn;
  private int turnedAway;
  private int left;
  private int towed;
  private int stopped;
  private int longestQueue;
  private int longestBeyondEdge;
  private long lastLeftNs;

  /**
   * @param untilNs the end of arrivals
   */
  OpenRoadStory(long untilNs) {
    this.untilNs = untilNs;
  }

  /** Somebody has come to the edge of the road. */
  void arrived(Arrival arrival) {
    arrived++;
    longestQueue = Math.max(longestQueue, count(queues, arrival, 1));
    longestBeyondEdge = Math.max(longestBeyondEdge, count(beyondEdge, arrival, 1));
  }

  /** Somebody who had arrived comes onto the road. */
  void cameIn(Arrival arrival) {
    cameIn++;
    count(beyondEdge, arrival, -1);
    waiting.put(arrival.id(), arrival);
    onFloor.add(arrival.id());
  }

  /** So many who had arrived never came onto the road. */
  void turnedAway(int cars) {
    turnedAway += cars;
  }

  /** So many were towed until now. */
  void towed(int cars) {
    towed = cars;
  }

  private int crossed() {
    return left - towed;
  }

  private static int count(Map<Zone, Integer> byArm, Arrival arrival, int more) {
    return byArm.merge(arrival.route().from(), more, Integer::sum);
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Variable variable) {
      if (variable.source().equals(CrossingTrace.SOURCE)
          && variable.name().equals(CrossingTrace.LOCATION)
          && variable.value().equals(Location.MOVE_WAIT.name())) {
        granted(variable);
      } else if (variable.name().equals("motionflag") && variable.value().equals("FAIL")) {
        stopped++;
      }
    } else if (event instanceof TraceEvent.Left gone && onFloor.remove(gone.robot())) {
      left++;
      lastLeftNs = gone.timeNs();
      leftNs.add(lastLeftNs);
      Arrival towedBefore = waiting.remove(gone.robot());
      if (towedBefore != null) {
        count(queues, towedBefore, -1);
      }
    }
  }

  private void granted(Variable event) {
    Arrival arrival = waiting.remove(event.robot());
    if (arrival != null) {
      count(queues, arrival, -1);
      waitsNs.add(event.timeNs() - arrival.atNs());
    }
  }

  @Override
  public List<String> lines() {
    long[] waits = sortedWaitsNs();
    List<String> lines = new ArrayList<>();
    lines.add(
        arrived
            + " cars arrived in "
            + seconds(untilNs)
            + " ("
            + perMinute(arrived, untilNs)
            + "), "
            + cameIn
            + " came onto the road, "
            + turnedAway
            + " turned away at the end of arrivals");
    lines.add(
        crossed()
            + " crossed ("
            + perMinute(crossed(), lastLeftNs)
            + "), the last one left at "
            + seconds(lastLeftNs));
    lines.add(
        "from arrival to being granted its zones a car waited "
            + wait(waits, 50)
            + " (median), 95 % up to "
            + wait(waits, 95)
            + ", the longest "
            + wait(waits, 100));
    lines.add(
        "longest queue of an arm: "
            + longestQueue
            + " cars; beyond the edge: "
            + longestBeyondEdge);
    if (towed > 0) {
      lines.add(towed + " dead cars were towed");
    }
    if (stopped > 0) {
      lines.add("cars were stopped by something " + (stopped == 1 ? "once" : stopped + " times"));
    }
    return lines;
  }

  @Override
  public Measures measures() {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("arrived", (double) arrived);
    figures.put("crossed", (double) crossed());
    figures.put("crossed_per_min", lastLeftNs == 0 ? 0 : crossed() * NS_PER_MIN / lastLeftNs);
    figures.put("longest_queue", (double) longestQueue);
    figures.put("towed", (double) towed);
    figures.put("turned_away", (double) turnedAway);
    return new Measures(cameIn, crossed(), waitsNs, figures);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("wait from arriving to being granted all zones", waitsNs),
        Sample.when("cars that have left", leftNs));
  }

  private long[] sortedWaitsNs() {
    long[] waits = waitsNs.stream().mapToLong(Long::longValue).toArray();
    Arrays.sort(waits);
    return waits;
  }

  private static String wait(long[] sortedWaitsNs, int percent) {
    return seconds(Measures.waitNs(sortedWaitsNs, percent));
  }

  private static String perMinute(int cars, long ns) {
    return String.format(Locale.ROOT, "%.1f/min", ns == 0 ? 0 : cars * NS_PER_MIN / ns);
  }

  private static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", ns / NS_PER_S);
  }
}
