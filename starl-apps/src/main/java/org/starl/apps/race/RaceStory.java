package org.starl.apps.race;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Reports the winner of each point, when it won, and how many robots arrived. */
final class RaceStory implements Story {

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

    /** How many of the known winners were kept off. */
    long keptOff() {
      return known.values().stream().distinct().filter(Claim::wasKeptOff).count();
    }
  }

  RaceStory(List<RacePoint> points) {
    this.points = List.copyOf(points);
    points.forEach(point -> races.add(new Race()));
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof RaceFact.Arrived arrived) {
      races.get(arrived.point()).arrivals++;
    }
    Claim claim = RaceFact.taken(event);
    if (claim != null) {
      Race race = races.get(claim.point());
      race.firstNs = race.known.isEmpty() ? event.timeNs() : race.firstNs;
      race.lastNs = event.timeNs();
      race.known.put(event.robot(), claim);
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
      lines.add(points.get(i).name() + ": " + result(races.get(i)));
    }
    lines.add(returned + " of " + robots + " robots ended, at " + Time.text(endNs, 1));
    return lines;
  }

  private static String result(Race race) {
    if (race.known.isEmpty()) {
      return "not won";
    }
    Claim best = race.known.values().stream().min(Claim::compareTo).orElseThrow();
    return String.format(
        "%s at %s%s%s; all robots knew after %s",
        best.winner(),
        Time.text(best.atNs(), 1),
        best.wasKeptOff() ? ", kept off by " + best.keptOffMm() + " mm" : "",
        race.arrivals > 1 ? ", of " + race.arrivals + " that arrived" : "",
        Time.text(race.lastNs - race.firstNs, 1));
  }

  @Override
  public Measures measures() {
    SortedMap<String, Long> counts = new TreeMap<>();
    counts.put("arrivals", races.stream().mapToLong(race -> race.arrivals).sum());
    counts.put("kept_off", won().stream().mapToLong(Race::keptOff).sum());
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
}
