package org.starl.cli.campaign;

import java.io.IOException;
import java.util.List;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The option of a command whose runs an engine can run. */
final class EngineOptions {

  @Option(
      names = "--on",
      paramLabel = "ENGINE[=MASTER]",
      description =
          "Use an engine: 'spark' on this machine, 'spark=spark://host:7077' on a"
              + " cluster. The output is the same.")
  private @Nullable String engine;

  /** Whether an engine runs. */
  boolean isOn() {
    return engine != null;
  }

  /**
   * Runs all.
   *
   * @param cores of this machine to use, if it is the only one
   * @param parquet the folder for the rows as Parquet; null without
   * @param isLast gets each row in order; after the first true the work ends
   * @param progress shows it; the caller ends it
   * @return false if a signal has ended it
   * @throws BadInput if an engine cannot run it
   */
  <R> boolean run(
      BaseCommand command,
      ShardWork<R> work,
      int cores,
      @Nullable String parquet,
      Predicate<R> isLast,
      ProgressLine progress)
      throws InterruptedException, IOException {
    if (!work.isNumbered()) {
      throw new BadInput(
          "--on cannot be used with --strategy exhaustive; expected --shard, or another strategy");
    }
    String[] words = String.valueOf(engine).split("=", 2);
    String master = words.length == 1 ? "" : words[1];
    Seeds.Range numbers = work.numbers();
    String header = ShardHeader.of(work, new Shard(1, 1), command.typed()).line();
    SeedPart all = new SeedPart(header, numbers.first(), numbers.last());
    InOrder<R> rows = new InOrder<>(work, isLast, progress);
    CampaignEngine found = named(words[0]);
    IOException[] failure = new IOException[1];
    boolean isWhole =
        command
            .stop()
            .completes(() -> {
              try {
                found.run(master, cores, all, parquet, rows);
              } catch (IOException e) {
                failure[0] = e;
              }
            });
    if (command.stop().isStopped()) { // the engine stops at the signal, too, and then gives up
      return isWhole && failure[0] == null;
    }
    if (failure[0] != null) {
      throw failure[0];
    }
    rows.requireAll();
    return true;
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

  /** Hands on the rows of parts in order; those that are early wait as text. */
  private static final class InOrder<R> implements CampaignEngine.Rows {

    private final ShardWork<R> work;
    private final Predicate<R> isLast;
    private final ProgressLine progress;
    private final SortedMap<Long, List<String>> early = new TreeMap<>();
    private long next;
    private long taken;
    private boolean isOver;

    InOrder(ShardWork<R> work, Predicate<R> isLast, ProgressLine progress) {
      this.work = work;
      this.isLast = isLast;
      this.progress = progress;
      next = work.numbers().first();
    }

    @Override
    public boolean take(SeedPart part, List<String> lines) {
      early.put(part.first(), lines);
      taken += lines.size();
      progress.show(taken, work.numbers().size());
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
      String where = work.unit() + " " + next + ": ";
      R row = work.row(where, line);
      if (!work.place(row).equals(List.of(next))) {
        throw new IllegalStateException(where + "got the row of " + work.place(row));
      }
      next++;
      isOver = isLast.test(row) || next > work.numbers().last();
    }

    @Override
    public long last() {
      return next - 1;
    }

    void requireAll() {
      if (!isOver) {
        throw new IllegalStateException("the engine gave no row of " + work.unit() + " " + next);
      }
    }
  }
}
