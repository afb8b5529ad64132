package org.starl.sim.explore;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;

/** Draws schedules for a run of which one order is known. */
final class Draws {

  /** More delayed links would slow the network down. */
  private static final int MOST_LINKS = 16;

  private final Bounds bounds;
  private final List<Copy> copies;
  private final List<Link> links;
  // Delays end here, so that progress is required of a run that takes longer.
  private final long untilNs;

  private record Link(String from, String to) {
    Fault delayed(long extraNs, long atNs, long untilNs) {
      return FaultGrammar.parse(
          "delay(%s,from=%s,to=%s,at=%s,until=%s)"
              .formatted(
                  Quantities.durationText(extraNs),
                  from,
                  to,
                  Quantities.durationText(atNs),
                  Quantities.durationText(untilNs)));
    }
  }

  /**
   * @param order of the run without changes
   */
  Draws(Bounds bounds, Order order) {
    this.bounds = bounds;
    copies = order.copies();
    Set<Link> seen = new LinkedHashSet<>();
    copies.forEach(copy -> seen.add(new Link(copy.from(), copy.to())));
    links = List.copyOf(seen);
    untilNs = Math.max(order.endNs(), bounds.fromNs());
  }

  /** All links get an additional delay, drawn for each copy. */
  List<Fault> random(Rng rng) {
    List<Fault> schedule = new ArrayList<>();
    long mostNs = Math.round(bounds.mostExtraNs() * rng.nextDouble());
    if (mostNs > 0) {
      schedule.add(
          FaultGrammar.parse(
              "delay(uniform(0ms,%s),at=%s,until=%s)"
                  .formatted(
                      Quantities.durationText(mostNs),
                      Quantities.durationText(bounds.fromNs()),
                      Quantities.durationText(untilNs))));
    }
    addLossesAndCrashes(rng, schedule);
    return schedule;
  }

  /**
   * Links get priorities: the highest no additional delay, the lowest the largest one. At {@code
   * changes} drawn copies the link of that copy gets the lowest priority.
   */
  List<Fault> pct(int changes, Rng rng) {
    List<Link> drawn = new ArrayList<>(links);
    while (drawn.size() > MOST_LINKS) {
      drawn.remove(rng.nextInt(drawn.size()));
    }
    List<Fault> schedule = new ArrayList<>();
    List<Link> byPriority = new ArrayList<>();
    while (!drawn.isEmpty()) {
      byPriority.add(drawn.remove(rng.nextInt(drawn.size())));
    }
    for (int rank = 1; rank < byPriority.size(); rank++) {
      schedule.add(
          byPriority.get(rank).delayed(extraNs(rank, byPriority), bounds.fromNs(), untilNs));
    }
    for (int i = 0; i < changes && !copies.isEmpty(); i++) {
      Copy at = copies.get(rng.nextInt(copies.size()));
      int rank = byPriority.indexOf(new Link(at.from(), at.to()));
      if (rank >= 0) {
        Link link = byPriority.get(rank);
        long moreNs = bounds.mostExtraNs() - extraNs(rank, byPriority);
        // Another change of this link adds nothing: it has the lowest priority.
        byPriority.set(rank, new Link("", ""));
        schedule.add(link.delayed(moreNs, at.sentAtNs(), untilNs));
      }
    }
    addLossesAndCrashes(rng, schedule);
    return schedule;
  }

  private long extraNs(int rank, List<Link> byPriority) {
    return bounds.mostExtraNs() * rank / Math.max(1, byPriority.size() - 1);
  }

  private void addLossesAndCrashes(Rng rng, List<Fault> schedule) {
    if (copies.isEmpty()) {
      return;
    }
    int losses = rng.nextInt(bounds.losses() + 1);
    for (int i = 0; i < losses; i++) {
      schedule.add(copies.get(rng.nextInt(copies.size())).lost());
    }
    int crashes = rng.nextInt(bounds.crashes() + 1);
    for (int i = 0; i < crashes; i++) {
      Copy at = copies.get(rng.nextInt(copies.size()));
      schedule.add(crash(rng.nextBoolean(0.5) ? at.from() : at.to(), at.sentAtNs() + 1, bounds));
    }
  }

  /** The robot crashes at that time, and restarts. */
  static Fault crash(String robot, long atNs, Bounds bounds) {
    return FaultGrammar.parse(
        "crash(%s,at=%s,restart=%s)"
            .formatted(
                robot, Quantities.durationText(atNs), Quantities.durationText(bounds.downNs())));
  }
}
