package org.starl.apps.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.FleetFact;
import org.starl.sim.SimResult;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** Reports when each delivery was asked for and put down, and deliveries an hour. */
final class FleetStory implements Story {

  private static final double HOUR_NS = 3600e9;
  private static final int MOST_LINES = 20;

  private final List<Delivery> deliveries;
  private final SortedMap<Long, Long> waitsNs = new TreeMap<>();
  private final List<String> lines = new ArrayList<>();
  private final List<Long> downNs = new ArrayList<>();
  private long charges;
  private long endNs;

  FleetStory(List<Delivery> deliveries) {
    this.deliveries = List.copyOf(deliveries);
  }

  @Override
  public void observed(TraceEvent event) {
    if (!(event instanceof Variable variable)) {
      return;
    }
    Long number = variable.of(FleetFact.DELIVERED);
    if (number != null && number > 0 && !waitsNs.containsKey(number)) {
      long waitNs = event.timeNs() - deliveries.get((int) (number - 1)).atNs();
      waitsNs.put(number, waitNs);
      downNs.add(event.timeNs());
      if (lines.size() < MOST_LINES) {
        lines.add(
            String.format(
                Locale.ROOT,
                "%8.1f s  %s puts down delivery %d, %.0f s after it was asked for",
                Time.seconds(event.timeNs()),
                event.robot(),
                number,
                Time.seconds(waitNs)));
      }
    }
    charges += variable.of(FleetFact.WORK) == FleetFact.Work.CHARGES ? 1 : 0;
  }

  @Override
  public void finished(SimResult result) {
    endNs = result.endNs();
  }

  @Override
  public List<String> lines() {
    List<String> all = new ArrayList<>(lines);
    if (waitsNs.size() > lines.size()) {
      all.add("  and " + (waitsNs.size() - lines.size()) + " more");
    }
    all.add(
        String.format(
            Locale.ROOT,
            "%d of %d deliveries, %.0f an hour, charged %d times",
            waitsNs.size(),
            deliveries.size(),
            anHour(),
            charges));
    return all;
  }

  /** Until the last one was put down; 0 if there was none. */
  private double anHour() {
    long lastNs = downNs.isEmpty() ? endNs : downNs.get(downNs.size() - 1);
    return lastNs == 0 ? 0 : waitsNs.size() * HOUR_NS / lastNs;
  }

  @Override
  public Measures measures() {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("deliveries_an_hour", anHour());
    SortedMap<String, Long> counts = new TreeMap<>();
    counts.put("charges", charges);
    List<Long> waits = List.copyOf(waitsNs.values());
    return new Measures("deliveries", deliveries.size(), waits.size(), waits, figures, counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("deliveries put down", downNs),
        Sample.howLong("time from a request to its delivery", List.copyOf(waitsNs.values())));
  }
}
