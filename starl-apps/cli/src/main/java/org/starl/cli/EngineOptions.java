package org.starl.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The options of a campaign that an engine runs. */
final class EngineOptions {

  @Option(
      names = "--on",
      paramLabel = "ENGINE[=MASTER]",
      description =
          "Run the seeds on an engine: 'spark' on this machine, 'spark=spark://host:7077' on a"
              + " cluster. The output is the same.")
  private @Nullable String engine;

  @Option(
      names = "--parquet",
      paramLabel = "FOLDER",
      description = "With --on: also write a row for each run to FOLDER, as Parquet.")
  private @Nullable String parquet;

  /**
   * Whether an engine runs the campaign.
   *
   * @throws BadInput if an option needs the other
   */
  boolean isOn() {
    if (engine == null && parquet != null) {
      throw new BadInput("--parquet needs --on ENGINE");
    }
    return engine != null;
  }

  /**
   * Runs the campaign.
   *
   * @param cores of this machine to use, if it is the only one
   * @param isLast gets each row in seed order; after the first true the campaign ends
   */
  void run(ShardHeader header, String key, int cores, Predicate<SeedRow> isLast, PrintWriter err)
      throws InterruptedException, IOException {
    String[] words = String.valueOf(engine).split("=", 2);
    String master = words.length == 1 ? "" : words[1];
    Seeds.Range seeds = header.range();
    SeedPart all = new SeedPart(header.line(), seeds.first(), seeds.last());
    ProgressLine progress = new ProgressLine(err, "runs");
    InOrder rows = new InOrder(key, seeds, isLast, progress);
    named(words[0]).run(master, cores, all, parquet, rows);
    progress.end();
    rows.requireAll();
  }

  private static CampaignEngine named(String name) {
    for (CampaignEngine engine : ServiceLoader.load(CampaignEngine.class)) {
      if (engine.name().equals(name)) {
        return engine;
      }
    }
    if (name.equals("spark")) {
      throw new MissingDependencyException(
          "--on spark: Spark is not on the class path; expected './starl campaign', which adds it,"
              + " or 'spark-submit starl-spark.jar campaign'");
    }
    throw new BadInput("--on: " + BadInput.quote(name) + ": expected spark or spark=MASTER");
  }

  /** Hands on the rows of parts in the order of seeds; those that are early wait as text. */
  private static final class InOrder implements CampaignEngine.Rows {

    private final String key;
    private final Seeds.Range range;
    private final Predicate<SeedRow> isLast;
    private final ProgressLine progress;
    private final SortedMap<Long, List<String>> early = new TreeMap<>();
    private long next;
    private long taken;
    private boolean isOver;

    InOrder(String key, Seeds.Range range, Predicate<SeedRow> isLast, ProgressLine progress) {
      this.key = key;
      this.range = range;
      this.isLast = isLast;
      this.progress = progress;
      next = range.first();
    }

    @Override
    public boolean take(SeedPart part, List<String> lines) {
      early.put(part.first(), lines);
      taken += lines.size();
      progress.show(taken, range.size());
      for (List<String> ready = early.remove(next);
          ready != null && !isOver;
          ready = early.remove(next)) {
        ready.forEach(this::add);
      }
      return isOver;
    }

    private void add(String line) {
      if (isOver) {
        return;
      }
      String where = "seed " + next + ": ";
      SeedRow row = SeedRow.of(where, line);
      if (row.seed() != next || !row.key().equals(key)) {
        throw new IllegalStateException(where + "got the row of seed " + row.seed());
      }
      next++;
      isOver = isLast.test(row) || next > range.last();
    }

    @Override
    public long lastSeed() {
      return next - 1;
    }

    void requireAll() {
      if (!isOver) {
        throw new IllegalStateException("the engine gave no row of seed " + next);
      }
    }
  }
}
