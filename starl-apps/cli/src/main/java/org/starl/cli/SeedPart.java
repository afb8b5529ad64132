package org.starl.cli;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.starl.sim.check.Campaign;
import org.starl.sim.kernel.CarrierKind;

/**
 * Neighbouring seeds of a campaign, for an engine to run in any process that has StarL and the app
 * on its class path. Equal parts give equal rows, so an engine may run a part again.
 *
 * @param header the first line of a shard's file: the campaign
 */
public record SeedPart(String header, long first, long last) implements Serializable {

  /** Long enough to outweigh the start of a task; its rows fit in a message of Spark. */
  private static final int MOST_SEEDS = 100;

  private static final int LEAST_PARTS_PER_CORE = 4;

  /** Smaller parts of these seeds, in order, so that {@code cores} have similar amounts of work. */
  public List<SeedPart> split(int cores) {
    long seeds = last - first + 1;
    long least = Math.min(seeds, (long) LEAST_PARTS_PER_CORE * cores);
    int count = (int) Math.max(least, (seeds + MOST_SEEDS - 1) / MOST_SEEDS);
    List<SeedPart> parts = new ArrayList<>();
    for (int i = 1; i <= count; i++) {
      Seeds.Range part = new Shard(i, count).seeds(new Seeds.Range(first, last));
      parts.add(new SeedPart(header, part.first(), part.last()));
    }
    return parts;
  }

  /**
   * Runs the seeds on the calling thread's core.
   *
   * @return the line of each row, in the order of seeds; with {@code --stop} the first bad run is
   *     the last
   * @throws org.starl.input.BadInput if this process has another version of StarL, or lacks the app
   */
  public List<String> run() throws InterruptedException {
    ShardHeader campaign = ShardHeader.read("campaign", header);
    RunRequest request = campaign.request("campaign", Main.installed());
    List<String> lines = new ArrayList<>();
    new SeedRuns(request, CarrierKind.best(), true)
        .run(
            new Campaign(first, last, 1, campaign.ending().stops()),
            (finished, planned, bad) -> {},
            row -> {
              lines.add(row.line());
              return false;
            });
    return lines;
  }
}
