package org.starl.cli.campaign;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.input.BadInput;
import org.starl.sim.explore.ExplorationTally;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl merge}. */
@Command(
    name = "merge",
    description =
        "Merges the files of 'campaign --out', 'sweep --out' or 'explore --out', and prints what the"
            + " command prints in one process. A run may be in several files: if its rows differ, the"
            + " program is not deterministic, and the status is 1.",
    footer = {"", "Example: starl merge part-* --report crossings.html"})
public final class MergeCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(arity = "1..*", paramLabel = "FILE", description = "Files of '--out'.")
  private List<String> files = new ArrayList<>();

  @Option(names = "--shrink", description = "Reduce the first bad run, as 'campaign --shrink'.")
  private boolean shrink;

  @Option(
      names = "--report",
      paramLabel = "FILE",
      description = "Write an HTML page, as 'campaign --report' and 'sweep --report'.")
  private @Nullable String report;

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Write all measures of all points, as 'sweep --csv'.")
  private @Nullable String csv;

  @Option(
      names = "--chart",
      paramLabel = "FILE",
      description = "Write a message sequence chart of the failure, as 'explore --chart'.")
  private @Nullable String chart;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws InterruptedException, IOException {
    try (ShardMerge merge = new ShardMerge(files)) {
      ShardWork<?> work = merge.work(demos());
      if (work instanceof ExploreWork exploration) {
        requireNone(work, "--shrink", shrink, "--report", report, "--csv", csv);
        return explored(merge, exploration);
      }
      SeedWork seeds = (SeedWork) work;
      if (seeds.sweep() != null) {
        requireNone(work, "--shrink", shrink, "--chart", chart, "--json", json.isOn());
        return swept(merge, seeds, seeds.sweep());
      }
      requireNone(work, "--csv", csv, "--chart", chart);
      return ran(merge, seeds);
    }
  }

  private static void requireNone(ShardWork<?> work, @Nullable Object... namesAndValues) {
    for (String option : OptionValues.given(namesAndValues)) {
      throw new BadInput(
          option + " cannot be used with files of 'starl " + work.command() + " --out'");
    }
  }

  private int ran(ShardMerge merge, SeedWork work) throws InterruptedException, IOException {
    CampaignTally tally = new CampaignTally(SteeredRuns.mayFollow(work.points().getFirst()));
    try (ReportFile page = ReportFile.of(report, work.seeds())) {
      merge.read(work, CampaignCommand.collector(work.ending(), tally, page));
      return differs(merge)
          ? ExitStatus.VIOLATED
          : CampaignCommand.print(
              new CampaignCommand.Output(
                  this,
                  work,
                  Carriers.select(null, err()),
                  Runtime.getRuntime().availableProcessors(),
                  json.isOn(),
                  shrink,
                  report,
                  merge.header().command(),
                  ""),
              tally,
              page);
    }
  }

  private int swept(ShardMerge merge, SeedWork work, SweepFile file) throws IOException {
    try (SweepCommand.Output output = new SweepCommand.Output(this, file, work, csv, report)) {
      merge.read(work, output::add);
      return differs(merge) ? ExitStatus.VIOLATED : output.print(true);
    }
  }

  private int explored(ShardMerge merge, ExploreWork work)
      throws InterruptedException, IOException {
    try (OutputFile file = chart == null ? null : new OutputFile("--chart", chart)) {
      ExplorationTally tally = new ExplorationTally(work.exploration());
      boolean isAll = merge.read(work, row -> tally.add(row.explored()));
      return differs(merge)
          ? ExitStatus.VIOLATED
          : ExploreCommand.print(
              new ExploreCommand.Output(
                  this, work, Carriers.select(null, err()), json.isOn(), chart, file),
              tally.result(isAll && !work.isNumbered()));
    }
  }

  private boolean differs(ShardMerge merge) {
    merge.differences().forEach(line -> err().println("starl: " + line));
    return !merge.differences().isEmpty();
  }
}
