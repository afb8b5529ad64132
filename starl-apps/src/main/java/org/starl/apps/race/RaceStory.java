package org.starl.apps.race;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.logic.RaceTrace;
import org.starl.apps.race.logic.Scoreboard;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Who won which point, when, and who bumped into whom. */
final class RaceStory implements Story {

  private static final double NS_PER_S = 1e9;

  private final List<RacePoint> points;
  private final List<Race> races = new ArrayList<>();
  private int robots;
  private int returned;
  private long endNs;

  /** For one point. */
  private static final class Race {
    private final SortedMap<RobotId, Claim> known = new TreeMap<>();
    private int arrivals;
    private long firstNs = -1;
    private long lastNs;
  }

  RaceStory(List<RacePoint> points) {
    this.points = List.copyOf(points);
    points.forEach(point -> races.add(new Race()));
  }

  @Override
  public void observed(TraceEvent event) {
    if (!(event instanceof Action action) || !action.source().equals(RaceTrace.SOURCE)) {
      return;
    }
    if (action.name().equals(RaceTrace.ARRIVE)) {
      races.get(Integer.parseInt(action.args().get(0))).arrivals++;
    } else if (action.name().equals(Scoreboard.TAKEN)) {
      Claim claim = Scoreboard.claim(action.args());
      Race race = races.get(claim.point());
      race.known.put(action.robot(), claim);
      race.firstNs = race.firstNs < 0 ? action.timeNs() : race.firstNs;
      race.lastNs = action.timeNs();
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
    lines.add(returned + " of " + robots + " robots came to the end, at " + seconds(endNs));
    return lines;
  }

  private static String told(Race race) {
    if (race.known.isEmpty()) {
      return "nobody's";
    }
    Claim best = race.known.values().stream().min(Claim::compareTo).orElseThrow();
    StringBuilder line = new StringBuilder(best.winner().name());
    line.append(" at ").append(seconds(best.atNs()));
    if (best.wasKeptOff()) {
      line.append(", kept off by ").append(best.keptOffMm()).append(" mm");
    }
    if (race.arrivals > 1) {
      line.append(", of ").append(race.arrivals).append(" that arrived");
    }
    return line.append("; all knew after ").append(seconds(race.lastNs - race.firstNs)).toString();
  }

  @Override
  public Measures measures() {
    List<Long> waits = new ArrayList<>();
    SortedMap<String, Long> counts = new TreeMap<>();
    long before = 0;
    for (Race race : races) {
      if (race.firstNs >= 0) {
        waits.add(Math.max(0, race.firstNs - before));
        before = race.firstNs;
      }
      counts.merge("arrivals", (long) race.arrivals, Long::sum);
      for (Claim claim : Map.copyOf(race.known).values().stream().distinct().toList()) {
        counts.merge("kept_off", claim.wasKeptOff() ? 1L : 0L, Long::sum);
      }
    }
    return new Measures(robots, returned, waits, new TreeMap<>(), counts);
  }

  @Override
  public List<Sample> samples() {
    List<Long> taken = new ArrayList<>();
    List<Long> spread = new ArrayList<>();
    for (Race race : races) {
      if (race.firstNs >= 0) {
        taken.add(race.firstNs);
        spread.add(race.lastNs - race.firstNs);
      }
    }
    return List.of(
        Sample.when("points taken", taken),
        Sample.howLong("time between two points' being taken", measures().waitsNs()),
        Sample.howLong("time until all knew who had a point", spread));
  }

  private static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", ns / NS_PER_S);
  }
}
