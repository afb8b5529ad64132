package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.Collection;
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
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.apps.intersection.robot.Car;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/** Reports the traffic of an open road. Of a car that has left, it keeps only two times. */
final class OpenRoadStory implements Story {

  private long untilNs;
  private final Set<RobotId> onFloor = new TreeSet<>();

  /** The cars on the floor that wait for their zones. */
  private final Map<RobotId, Car> waiting = new TreeMap<>();

  private final List<Long> waitsNs = new ArrayList<>();
  private final List<Long> leftNs = new ArrayList<>();
  private final List<Long> delaysNs = new ArrayList<>();
  private final Map<RobotId, Car> cars = new TreeMap<>();
  private final double radiusMm;
  private final double mmPerS;
  private int arrived;
  private int entered;
  private int turnedAway;
  private int towed;
  private int stopped;
  private int longestQueue;
  private int longestBeyondEdge;

  /**
   * @param untilNs the latest end of arrivals
   * @param radiusMm of a car's body
   * @param mmPerS speed of a car that is alone
   */
  OpenRoadStory(long untilNs, double radiusMm, double mmPerS) {
    this.untilNs = untilNs;
    this.radiusMm = radiusMm;
    this.mmPerS = mmPerS;
  }

  /** All cars have arrived. */
  void arrivalsEnded(long nowNs) {
    untilNs = nowNs;
  }

  /**
   * A car has arrived at the edge of the road.
   *
   * @param beyondEdge number of cars of its arm beyond the edge, this one included
   */
  void arrived(Car car, int beyondEdge) {
    arrived++;
    long inside = waiting.values().stream().filter(w -> w.arm().equals(car.arm())).count();
    longestQueue = Math.max(longestQueue, beyondEdge + (int) inside);
    longestBeyondEdge = Math.max(longestBeyondEdge, beyondEdge);
  }

  /** A car that had arrived enters the road. */
  void entered(Car car) {
    entered++;
    waiting.put(car.id(), car);
    cars.put(car.id(), car);
    onFloor.add(car.id());
  }

  /** Cars that had arrived turn away; they have waited until now. */
  void turnedAway(Collection<Car> away, long nowNs) {
    turnedAway += away.size();
    away.forEach(car -> {
      waitsNs.add(nowNs - car.readyNs());
      delaysNs.add(nowNs - car.readyNs());
    });
  }

  /** So many cars have been towed so far. */
  void towed(int cars) {
    towed = cars;
  }

  @Override
  public void observed(TraceEvent event) {
    if (CrossingFact.location(event).filter(Location.MOVE_WAIT::equals).isPresent()) {
      Car car = waiting.remove(event.robot());
      if (car != null) {
        waitsNs.add(event.timeNs() - car.readyNs());
      }
    } else if (CrossingFact.isStopped(event)) {
      stopped++;
    } else if (event instanceof TraceEvent.Left && onFloor.remove(event.robot())) {
      leftNs.add(event.timeNs());
      waiting.remove(event.robot());
      Car car = cars.remove(event.robot());
      if (car != null) {
        delaysNs.add(event.timeNs() - car.readyNs() - freeNs(car));
      }
    }
  }

  /** Number of cars that crossed before arrivals ended. */
  private int inTime() {
    return (int) leftNs.stream().filter(timeNs -> timeNs <= untilNs).count();
  }

  /** The time that a car needs that is alone on the road. */
  private long freeNs(Car car) {
    double wayMm =
        car.trip()
            .route()
            .map(route -> Crossing.wayMm(route, Crossing.PLACES - 1, radiusMm))
            .orElse(0.0);
    return (long) (wayMm / mmPerS * Time.NS_PER_S);
  }

  private int crossed() {
    return leftNs.size() - towed;
  }

  private long lastLeftNs() {
    return leftNs.isEmpty() ? 0 : leftNs.get(leftNs.size() - 1);
  }

  private static double perMinute(int cars, long ns) {
    return ns == 0 ? 0 : 60 * cars / Time.seconds(ns);
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
            Time.text(untilNs, 1),
            perMinute(arrived, untilNs),
            entered,
            turnedAway));
    lines.add(
        String.format(
            Locale.ROOT,
            "%d crossed (%.1f/min), the last one left at %s",
            crossed(),
            perMinute(crossed(), lastLeftNs()),
            Time.text(lastLeftNs(), 1)));
    lines.add(
        String.format(
            Locale.ROOT,
            "time from arrival to the grant of zones, or to turning away: median %s, 95 %% up to %s, longest %s",
            Time.text(Measures.waitNs(waits, 50), 1),
            Time.text(Measures.waitNs(waits, 95), 1),
            Time.text(Measures.waitNs(waits, 100), 1)));
    lines.add(
        String.format(
            Locale.ROOT,
            "delay over a car that is alone: mean %.1f s, of all that arrived",
            Measures.meanS(delaysNs)));
    lines.add(
        String.format(
            Locale.ROOT,
            "longest queue of an arm: %d cars; beyond the edge: %d",
            longestQueue,
            longestBeyondEdge));
    if (towed > 0) {
      lines.add(towed + " dead cars were towed");
    }
    if (stopped > 0) {
      lines.add("cars were stopped on their way " + IntersectionStory.times(stopped));
    }
    return lines;
  }

  @Override
  public Measures measures() {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("crossed_in_time", (double) inTime());
    figures.put("arrived", (double) arrived);
    figures.put("crossed", (double) crossed());
    figures.put("crossed_per_min", perMinute(crossed(), lastLeftNs()));
    figures.put("delay_mean_s", Measures.meanS(delaysNs));
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
