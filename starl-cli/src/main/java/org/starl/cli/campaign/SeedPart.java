package org.starl.cli.campaign;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.starl.cli.command.Apps;
import org.starl.cli.request.Seeds;
import org.starl.sim.kernel.CarrierKind;

/**
 * Neighbouring runs of a campaign, a sweep or an exploration, for an engine to run in any process
 * that has StarL and the app on its class path. Equal parts give equal rows, so an engine may run a
 * part again.
 *
 * @param header the first line of a shard's file: the whole
 * @param first the number of the first run; in a campaign its seed
 */
public record SeedPart(String header, long first, long last) implements Serializable {

  /** Long enough to outweigh the start of a task; its rows fit in a message of Spark. */
  private static final int MOST_RUNS = 100;

  private static final int LEAST_PARTS_PER_CORE = 4;

  /** Smaller parts of these runs, in order, so that {@code cores} have similar amounts of work. */
  public List<SeedPart> split(int cores) {
    long runs = last - first + 1;
    long least = Math.min(runs, (long) LEAST_PARTS_PER_CORE * cores);
    int count = (int) Math.max(least, (runs + MOST_RUNS - 1) / MOST_RUNS);
    List<SeedPart> parts = new ArrayList<>();
    for (int i = 1; i <= count; i++) {
      Seeds.Range part = new Shard(i, count).seeds(new Seeds.Range(first, last));
      parts.add(new SeedPart(header, part.first(), part.last()));
    }
    return parts;
  }

  /**
   * Runs the part on the calling thread's core.
   *
   * @return the line of each row, in order; the first bad run is the last if it ends the whole
   * @throws org.starl.input.BadInput if this process has another version of StarL, or lacks the app
   */
  public List<String> run() throws InterruptedException {
    return run(ShardHeader.read("engine", header).work("engine", Apps.installed()));
  }

  private <R> List<String> run(ShardWork<R> work) throws InterruptedException {
    List<String> lines = new ArrayList<>();
    work.part(new Seeds.Range(first, last))
        .run(
            new ShardWork.How(CarrierKind.best(), 1, (finished, planned, bad) -> {}),
            row -> !lines.add(work.line(row)));
    return lines;
  }
}
