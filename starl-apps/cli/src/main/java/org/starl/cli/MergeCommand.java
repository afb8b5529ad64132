package org.starl.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl merge}. */
@Command(
    name = "merge",
    description =
        "Merges the files of 'starl campaign --out' and prints what one campaign of all their seeds"
            + " prints. A seed may be in several files: if its rows differ, the program is not"
            + " deterministic, and the status is 1.",
    footer = {"", "Example: starl merge part-* --report crossings.html"})
final class MergeCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(arity = "1..*", paramLabel = "FILE", description = "Files of 'starl campaign --out'.")
  private List<String> files = new ArrayList<>();

  @Option(names = "--shrink", description = "Reduce the first bad run, as 'campaign --shrink'.")
  private boolean shrink;

  @Option(
      names = "--report",
      paramLabel = "FILE",
      description = "Write an HTML page, as 'campaign --report'.")
  private @Nullable String report;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws InterruptedException, IOException {
    try (ShardMerge merge = new ShardMerge(files, demos())) {
      ShardHeader header = merge.header();
      CampaignTally tally = new CampaignTally();
      try (ReportFile page = ReportFile.of(report, header.range())) {
        merge.read(CampaignCommand.collector(header.ending(), tally, page));
        if (!merge.differences().isEmpty()) {
          merge.differences().forEach(line -> err().println("starl: " + line));
          return ExitStatus.VIOLATED;
        }
        CampaignCommand.Output output =
            new CampaignCommand.Output(
                this,
                merge.request(),
                header.range(),
                header.ending(),
                Carriers.select(null, err()),
                json.isOn(),
                shrink,
                report,
                header.command());
        return CampaignCommand.print(output, tally, page);
      }
    }
  }
}
