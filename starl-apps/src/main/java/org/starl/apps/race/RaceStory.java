package org.starl.apps.race;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.logic.RaceTrace;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Which robot won which point, when, and how many robots arrived. */
final class RaceStory implements Story {

  private static final double NS_PER_S = 1e9;

  private final List<RacePoint> points;
  private final List<Race> races = new ArrayList<>();
  private int robots;
  private int returned;
  private long endNs;

  /** The race to one point. */
  private static final class Race {
    private final SortedMap<RobotId, Claim> known = new TreeMap<>();
    private int arrivals;
    private long firstNs;
    private long lastNs;
  }

  RaceStory(List<RacePoint> points) {
    this.points = List.copyOf(points);
    points.forEach(point -> races.add(new Race()));
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Action action && RaceTrace.is(action, RaceTrace.ARRIVE)) {
      races.get(Integer.parseInt(action.args().get(0))).arrivals++;
    } else if (event instanceof Action action && RaceTrace.is(action, RaceTrace.TAKEN)) {
      Claim claim = Claim.ofTrace(action.args());
      Race race = races.get(claim.point());
      race.firstNs = race.known.isEmpty() ? action.timeNs() : race.firstNs;
      race.lastNs = action.timeNs();
      race.known.put(action.robot(), claim);
    }
  }

  @Override
  public void finished(SimResult result) {
    returned = result.results().size();
    robots = returned + result.unfinished().size();
    endNs = result.endNs();
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < races.size(); i++) {
      lines.add(points.get(i).name() + ": " + told(races.get(i)));
    }
    lines.add(returned + " of " + robots + " robots ended, at " + seconds(endNs));
    return lines;
  }

  private static String told(Race race) {
    if (race.known.isEmpty()) {
      return "not won";
    }
    Claim best = race.known.values().stream().min(Claim::compareTo).orElseThrow();
    return best.winner()
        + " at "
        + seconds(best.atNs())
        + (best.wasKeptOff() ? ", kept off by " + best.keptOffMm() + " mm" : "")
        + (race.arrivals > 1 ? ", of " + race.arrivals + " that arrived" : "")
        + "; all robots knew after "
        + seconds(race.lastNs - race.firstNs);
  }

  @Override
  public Measures measures() {
    SortedMap<String, Long> counts = new TreeMap<>();
    for (Race race : races) {
      counts.merge("arrivals", (long) race.arrivals, Long::sum);
      race.known.values().stream()
          .distinct()
          .forEach(claim -> counts.merge("kept_off", claim.wasKeptOff() ? 1L : 0L, Long::sum));
    }
    return new Measures(robots, returned, waitsNs(), new TreeMap<>(), counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("points taken", won().stream().map(race -> race.firstNs).toList()),
        Sample.howLong("time from one point's winner to the next", waitsNs()),
        Sample.howLong(
            "time until all robots knew a winner",
            won().stream().map(race -> race.lastNs - race.firstNs).toList()));
  }

  private List<Race> won() {
    return races.stream().filter(race -> !race.known.isEmpty()).toList();
  }

  private List<Long> waitsNs() {
    List<Long> waits = new ArrayList<>();
    long before = 0;
    for (Race race : won()) {
      waits.add(Math.max(0, race.firstNs - before));
      before = race.firstNs;
    }
    return waits;
  }

  private static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", ns / NS_PER_S);
  }
}
