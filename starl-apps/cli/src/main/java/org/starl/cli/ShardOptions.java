package org.starl.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.check.Campaign;
import picocli.CommandLine.Option;

/** The options of a campaign that writes a row for each run, for {@code starl merge}. */
final class ShardOptions {

  @Option(
      names = "--shard",
      paramLabel = "K/N",
      description =
          "Run only part K of N of the seeds; needs --out. 'starl merge' joins the parts.")
  private @Nullable String shard;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Write a row for each run to FILE, for 'starl merge', instead of a table.")
  private @Nullable String out;

  @Option(
      names = "--resume",
      description = "Continue FILE of --out after its last row; begin it if there is none.")
  private boolean resume;

  @Option(
      names = "--print-job",
      paramLabel = "SCHEDULER",
      description =
          "Run nothing, but print a job of --shards parts: kubernetes (an Indexed Job) or slurm (an"
              + " array script).")
  private JobScript.@Nullable Scheduler scheduler;

  @Option(
      names = "--shards",
      paramLabel = "N",
      defaultValue = "64",
      description = "Parts of the job of --print-job (default: ${DEFAULT-VALUE}).")
  private String shards = "64";

  /** Prints a job and returns true, if {@code --print-job} is given. */
  boolean printJob(PrintWriter out, String app, List<String> words, Seeds.Range range) {
    if (scheduler == null) {
      return false;
    }
    int count = OptionValues.whole("--shards", shards, 1, (int) range.size());
    out.print(JobScript.of(scheduler, app, words, count));
    return true;
  }

  /** Whether the campaign writes rows. */
  boolean isOn() {
    if (out == null && (shard != null || resume)) {
      throw new BadInput((shard != null ? "--shard" : "--resume") + " needs --out FILE");
    }
    return out != null;
  }

  /**
   * Runs the shard and writes its file.
   *
   * @return the exit status: good if the file is complete. Its runs may be bad; the merge tells
   */
  int run(
      BaseCommand command,
      RunRequest request,
      Seeds.Range range,
      int workers,
      Ending ending,
      String typed,
      JsonOption json)
      throws InterruptedException, IOException {
    String name = out == null ? "" : out;
    Shard part = shard == null ? new Shard(1, 1) : Shard.of("--shard", shard, range);
    Seeds.Range seeds = part.seeds(range);
    ShardHeader header = ShardHeader.of(request, range, part, ending, typed);
    CampaignTally tally = new CampaignTally();
    try (ShardFile file =
        resume
            ? ShardFile.resume(name, header, ShardHeader.key(request), tally::add)
            : ShardFile.create(name, header)) {
      boolean isOver = ending.stops() && tally.bad() > 0;
      long next = seeds.first() + tally.runs();
      if (!isOver && next <= seeds.last()) {
        run(
            command,
            request,
            new Campaign(next, seeds.last(), workers, ending.stops()),
            file,
            tally);
      }
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    Map<String, Object> object =
        Json.object(
            "app", request.demo().name(),
            "shard", part.toString(),
            "seeds", seeds.toString(),
            "rows", tally.runs(),
            "bad", tally.bad(),
            "file", name);
    json.print(
        command.out(),
        object,
        List.of(
            "%s, shard %s, seeds %s: %d rows in %s, %d bad"
                .formatted(request.demo().name(), part, seeds, tally.runs(), name, tally.bad())));
    return ExitStatus.GOOD;
  }

  private static void run(
      BaseCommand command,
      RunRequest request,
      Campaign campaign,
      ShardFile file,
      CampaignTally tally)
      throws InterruptedException {
    ProgressLine progress = new ProgressLine(command.err(), "runs");
    new SeedRuns(request, Carriers.select(null, command.err()), true)
        .run(
            campaign,
            progress::show,
            row -> {
              try {
                file.append(row);
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
              tally.add(row);
              return false;
            });
    progress.end();
  }
}
