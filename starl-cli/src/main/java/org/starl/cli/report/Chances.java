package org.starl.cli.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.sim.SimObserver;
import org.starl.sim.Simulation;
import org.starl.sim.check.ErrorRate;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * What a campaign shows of the probability that a run is bad, over all runs and over those with each
 * kind of fault: upper bounds, since seeds are independent samples of what the campaign draws.
 */
public final class Chances {

  /** Faults that last so long also count under {@link #LONG}: others suspect a silent robot by then. */
  private static final long LONG_NS = 10_000_000_000L;

  private static final String LONG = "10 s or longer";
  private static final double CONFIDENCE = 0.95;

  private Count all = new Count(0, 0);
  private final SortedMap<String, Count> byKind = new TreeMap<>();

  /** The kinds of faults of a run that is about to be built; complete at its end. */
  public static SortedSet<String> watch(Simulation.Builder simulation) {
    SortedSet<String> mine = new TreeSet<>();
    SortedMap<String, Long> beganNs = new TreeMap<>();
    simulation.observer(
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (event instanceof Fault fault && fault.name().equals(Fault.BEGIN)) {
              mine.add(fault.effect());
              beganNs.put(fault.detail(), fault.timeNs());
            } else if (event instanceof Fault fault && fault.name().equals(Fault.END)) {
              long sinceNs = beganNs.getOrDefault(fault.detail(), fault.timeNs());
              if (fault.timeNs() - sinceNs >= LONG_NS) {
                mine.add(LONG);
              }
            }
          }
        });
    return mine;
  }

  /** Bad runs, all runs. */
  record Count(long bad, long runs) {
    Count plus(boolean isGood) {
      return new Count(bad + (isGood ? 0 : 1), runs + 1);
    }

    double below() {
      return ErrorRate.below(bad, runs, CONFIDENCE);
    }

    String belowText() {
      return ErrorRate.text(below());
    }
  }

  /** Adds a run with these kinds of faults. */
  public void add(SortedSet<String> kinds, boolean isGood) {
    all = all.plus(isGood);
    for (String kind : kinds) {
      byKind.put(kind, byKind.getOrDefault(kind, new Count(0, 0)).plus(isGood));
    }
  }

  /** Each group of runs: all, with an empty name, then those with one kind of fault. */
  Map<String, Count> counts() {
    Map<String, Count> counts = new LinkedHashMap<>();
    counts.put("", all);
    counts.putAll(byKind);
    return counts;
  }

  /** A line for each group: {@code bad runs: 0 of 200: below 1.5 % at 95 %}. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    counts()
        .forEach((kind, count) ->
            lines.add(
                "%s%d of %d: below %s at 95 %%"
                    .formatted(
                        kind.isEmpty() ? "bad runs: " : "  with " + kind + ": ",
                        count.bad(),
                        count.runs(),
                        count.belowText())));
    return lines;
  }

  /** For {@code --json}. */
  public Map<String, Object> json() {
    Map<String, Object> json = new LinkedHashMap<>();
    counts()
        .forEach((kind, count) -> {
          Map<String, Object> object = new LinkedHashMap<>();
          object.put("bad", count.bad());
          object.put("runs", count.runs());
          object.put("below", count.below());
          json.put(kind.isEmpty() ? "all" : kind, object);
        });
    return json;
  }
}
