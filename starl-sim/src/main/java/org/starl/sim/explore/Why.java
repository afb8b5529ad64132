package org.starl.sim.explore;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.fault.Fault;

/**
 * Why a run went wrong: single copies of datagrams shortly before its failure, without whose
 * arrival, or with another time of whose arrival, the failure does not happen.
 *
 * @param cures changes that avoid the failure, of different copies, the one nearest to it first
 * @param tried the number of changes tried
 */
public record Why(List<Cure> cures, int tried) {

  /** Runs that are started together. */
  private static final int BATCH = 16;

  private static final int MOST_CURES = 3;

  /** Times tried for one copy, the nearest to its own time. */
  private static final int MOST_TIMES = 2;

  /**
   * A change that avoids the failure.
   *
   * @param copy as it was in the run that went wrong
   * @param message in the copy, as text; empty if it is not known
   * @param arrivesAtNs its other arrival, in ns of virtual time; {@link Copy#NEVER} if it is lost
   * @param change of it
   */
  public record Cure(Copy copy, String message, long arrivesAtNs, Fault change) {

    /** Whether the copy does not arrive. */
    public boolean isLoss() {
      return arrivesAtNs == Copy.NEVER;
    }
  }

  /**
   * Tries single changes.
   *
   * @param bounds begins some seconds before the failure
   * @param atNs time of the failure
   * @param runner of the run that went wrong
   * @param mostRuns the largest number of runs
   */
  public static Why of(Bounds bounds, long atNs, Explorer.Runner runner, int mostRuns)
      throws InterruptedException {
    Order order = new Order(bounds, Integer.MAX_VALUE);
    runner.run(List.of(), order);
    List<Cure> changes = changes(order, atNs);
    List<Cure> cures = new ArrayList<>();
    int tried = 0;
    while (cures.size() < MOST_CURES && tried < Math.min(changes.size(), mostRuns)) {
      int end = Math.min(Math.min(tried + BATCH, changes.size()), mostRuns);
      addCures(changes.subList(tried, end), bounds, runner, cures);
      tried = end;
    }
    return new Why(List.copyOf(cures.subList(0, Math.min(MOST_CURES, cures.size()))), tried);
  }

  /** Single changes of copies that were sent before {@code atNs}, the last of them first. */
  private static List<Cure> changes(Order order, long atNs) {
    List<Copy> copies = new ArrayList<>(order.copies());
    copies.removeIf(copy -> copy.isLost() || copy.sentAtNs() > atNs);
    Collections.reverse(copies);
    List<Cure> changes = new ArrayList<>();
    for (Copy copy : copies) {
      String message = order.message(copy);
      order.otherArrivals(copy).stream()
          .sorted((a, b) -> Long.compare(distance(copy, a), distance(copy, b)))
          .limit(MOST_TIMES)
          .forEach(timeNs -> changes.add(new Cure(copy, message, timeNs, copy.arrivingAt(timeNs))));
      changes.add(new Cure(copy, message, Copy.NEVER, copy.lost()));
    }
    return changes;
  }

  private static long distance(Copy copy, long timeNs) {
    return Math.abs(copy.arrivesAtNs() - timeNs);
  }

  private static void addCures(
      List<Cure> changes, Bounds bounds, Explorer.Runner runner, List<Cure> cures)
      throws InterruptedException {
    CampaignResult result =
        new Campaign(0, changes.size() - 1)
            .run(
                number -> {
                  List<Fault> change = List.of(changes.get((int) number).change());
                  return runner.run(change, new Order(bounds, 1));
                },
                (finished, planned, bad) -> {});
    for (CampaignResult.Run run : result.runs()) {
      Verdict verdict = run.outcome().verdict();
      // A shrunk run ends soon after its failure, before its apps do.
      if (verdict == Verdict.GOOD || verdict == Verdict.UNFINISHED) {
        Cure cure = changes.get((int) run.seed());
        if (cures.stream().noneMatch(other -> other.copy().equals(cure.copy()))) {
          cures.add(cure);
        }
      }
    }
  }
}
