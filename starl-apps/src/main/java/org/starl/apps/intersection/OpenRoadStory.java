package org.starl.apps.intersection;

import static org.starl.apps.intersection.IntersectionStory.seconds;

import java.util.ArrayList;
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
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/** Reports the traffic of an open road. Of a car that has left, it keeps only two times. */
final class OpenRoadStory implements Story {

  private static final double NS_PER_MIN = 60e9;

  private final long untilNs;
  private final SortedMap<RobotId, Car> waiting = new TreeMap<>();
  private final Set<RobotId> onFloor = new TreeSet<>();
  // Number of cars per arm that wait for their zones, and of those the ones beyond the edge.
  private final Map<String, Integer> queued = new TreeMap<>();
  private final Map<String, Integer> beyondEdge = new TreeMap<>();
  private final List<Long> waitsNs = new ArrayList<>();
  private final List<Long> leftNs = new ArrayList<>();
  private int arrived;
  private int entered;
  private int turnedAway;
  private int towed;
  private int stopped;
  private int longestQueue;
  private int longestBeyondEdge;

  /**
   * @param untilNs the end of arrivals
   */
  OpenRoadStory(long untilNs) {
    this.untilNs = untilNs;
  }

  /** A car has arrived at the edge of the road. */
  void arrived(Car car) {
    arrived++;
    longestQueue = Math.max(longestQueue, queued.merge(car.arm(), 1, Integer::sum));
    longestBeyondEdge = Math.max(longestBeyondEdge, beyondEdge.merge(car.arm(), 1, Integer::sum));
  }

  /** A car that had arrived enters the road. */
  void entered(Car car) {
    entered++;
    beyondEdge.merge(car.arm(), -1, Integer::sum);
    waiting.put(car.id(), car);
    onFloor.add(car.id());
  }

  /** So many cars that had arrived never entered. */
  void turnedAway(int cars) {
    turnedAway += cars;
  }

  /** So many cars have been towed so far. */
  void towed(int cars) {
    towed = cars;
  }

  @Override
  public void observed(TraceEvent event) {
    if (CrossingTrace.location(event).filter(Location.MOVE_WAIT::equals).isPresent()) {
      Car car = waiting.remove(event.robot());
      if (car != null) {
        queued.merge(car.arm(), -1, Integer::sum);
        waitsNs.add(event.timeNs() - car.readyNs());
      }
    } else if (CrossingTrace.isStopped(event)) {
      stopped++;
    } else if (event instanceof TraceEvent.Left && onFloor.remove(event.robot())) {
      leftNs.add(event.timeNs());
      Car towedBefore = waiting.remove(event.robot());
      if (towedBefore != null) {
        queued.merge(towedBefore.arm(), -1, Integer::sum);
      }
    }
  }

  private int crossed() {
    return leftNs.size() - towed;
  }

  private long lastLeftNs() {
    return leftNs.isEmpty() ? 0 : leftNs.get(leftNs.size() - 1);
  }

  private static double perMinute(int cars, long ns) {
    return ns == 0 ? 0 : cars * NS_PER_MIN / ns;
  }

  @Override
  public List<String> lines() {
    long[] waits = waitsNs.stream().mapToLong(Long::longValue).sorted().toArray();
    List<String> lines = new ArrayList<>();
    lines.add(
        String.format(
            Locale.ROOT,
            "%d cars arrived in %s (%.1f/min), %d entered the road, %d turned away",
            arrived,
            seconds(untilNs),
            perMinute(arrived, untilNs),
            entered,
            turnedAway));
    lines.add(
        String.format(
            Locale.ROOT,
            "%d crossed (%.1f/min), the last one left at %s",
            crossed(),
            perMinute(crossed(), lastLeftNs()),
            seconds(lastLeftNs())));
    lines.add(
        String.format(
            Locale.ROOT,
            "time from arrival to the grant of its zones: median %s, 95 %% up to %s, longest %s",
            seconds(Measures.waitNs(waits, 50)),
            seconds(Measures.waitNs(waits, 95)),
            seconds(Measures.waitNs(waits, 100))));
    lines.add(
        "longest queue of an arm: "
            + longestQueue
            + " cars; beyond the edge: "
            + longestBeyondEdge);
    if (towed > 0) {
      lines.add(towed + " dead cars were towed");
    }
    if (stopped > 0) {
      lines.add("cars were stopped on their way " + (stopped == 1 ? "once" : stopped + " times"));
    }
    return lines;
  }

  @Override
  public Measures measures() {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("arrived", (double) arrived);
    figures.put("crossed", (double) crossed());
    figures.put("crossed_per_min", perMinute(crossed(), lastLeftNs()));
    figures.put("longest_queue", (double) longestQueue);
    figures.put("towed", (double) towed);
    figures.put("turned_away", (double) turnedAway);
    return new Measures(entered, crossed(), waitsNs, figures);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("wait from arrival to the grant of all zones", waitsNs),
        Sample.when("cars that have left", leftNs));
  }
}
