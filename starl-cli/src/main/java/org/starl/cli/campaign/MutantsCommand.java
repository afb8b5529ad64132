package org.starl.cli.campaign;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.mutants.BugProcess;
import org.starl.cli.mutants.BugProcess.Tried;
import org.starl.cli.mutants.BugProcess.Verdict;
import org.starl.cli.mutants.BugWorker;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.sim.kernel.CarrierKind;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl mutants}. */
@Command(
    name = "mutants",
    description =
        "Plants one bug at a time in an app's classes, and runs the app with many seeds: are the"
            + " specifications good enough to find it? Prints the bugs that survive, and the lines"
            + " that no run reaches.",
    footer = {
      "",
      "Example: starl mutants race --chaos --seeds 1..20",
      "         starl mutants barrier --chaos --seeds 1..50"
          + " --classes 'org.starl.primitives.barrier.BarrierProtocol*'"
    })
public final class MutantsCommand extends BaseCommand implements Callable<Integer> {

  private static final int MOST_BUGS = 1_000_000;

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Option(
      names = "--seeds",
      paramLabel = "A..B",
      defaultValue = "1..20",
      description = "Seeds of the runs that are to find a bug (default: ${DEFAULT-VALUE}).")
  private String seeds = "";

  @Option(
      names = "--classes",
      paramLabel = "NAMES",
      description =
          "The classes, separated by commas; * stands for any text (default: the package of the app,"
              + " and those below).")
  private @Nullable String classes;

  @Option(
      names = "--most",
      paramLabel = "N",
      defaultValue = "60",
      description =
          "The largest number of bugs to try, evenly from all of them (default: ${DEFAULT-VALUE}).")
  private String most = "";

  @Option(names = "--worker", hidden = true)
  private boolean isWorker;

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws InterruptedException, IOException {
    Seeds.Range range = Seeds.Range.of(seeds);
    int mostBugs = OptionValues.whole("--most", most, 1, MOST_BUGS);
    RunRequest request = options.request(demos());
    request.plan(range.first()).simulation().build(); // refuses bad input
    String names = classes == null ? request.demo().getClass().getPackageName() + ".*" : classes;
    SeedWork work = SeedWork.campaign(request, range, Ending.of(true, "", range));
    if (isWorker) {
      CarrierKind carriers = Carriers.select(null, err());
      BugWorker.serve(names, () -> firstBad(work, carriers, threads.count()));
      return ExitStatus.GOOD;
    }
    List<String> words = new ArrayList<>(List.of(MAIN));
    words.addAll(originalWords());
    words.add("--worker");
    try (BugProcess process = new BugProcess(names, words)) {
      stop().calls(process::end);
      return run(process, names, mostBugs);
    } catch (IOException e) {
      if (!stop().isStopped()) {
        throw e;
      }
      err().println("starl: interrupted"); // the signal ended the second process
      return ExitStatus.NOT_DECIDED;
    }
  }

  /** The first run that is not as it should be. */
  private static String firstBad(SeedWork work, CarrierKind carriers, int workers)
      throws InterruptedException {
    CampaignTally tally = new CampaignTally(false);
    ShardWork.How how = new ShardWork.How(carriers, workers, (finished, planned, bad) -> {});
    work.runSeeds(
        work.numbers(), how, false, CampaignCommand.collector(work.ending(), tally, null));
    SeedRow bad = tally.firstBad();
    if (bad != null) {
      return "seed " + bad.seed() + ": " + bad.outcome().detail();
    }
    return tally.leavesUnchecked()
        ? "never checked: " + String.join(" ", tally.neverChecked())
        : "";
  }

  private int run(BugProcess process, String names, int mostBugs) throws IOException {
    BugProcess.Without without = process.without();
    if (!without.bad().isEmpty()) {
      err().println("bad without a bug: " + without.bad());
      return ExitStatus.VIOLATED;
    }
    int[] reached =
        IntStream.range(0, without.bugs().size())
            .filter(bug -> without.bugs().get(bug).isRun())
            .toArray();
    int planned = Math.min(mostBugs, reached.length);
    SortedMap<Verdict, Integer> counts = new TreeMap<>();
    ProgressLine progress = progress("bugs");
    List<Tried> lines = new ArrayList<>();
    int tried = 0;
    while (tried < planned && !stop().isStopped()) {
      int bug = reached[(int) ((long) tried * reached.length / planned)];
      Tried one = process.with(bug);
      if (stop().isStopped()) {
        break; // the signal ended it, not the bug
      }
      tried++;
      counts.merge(one.verdict(), 1, Integer::sum);
      lines.add(one);
      progress.show(tried, planned);
    }
    progress.end();
    lines.forEach(this::print);
    if (!json.isOn()) {
      without.neverRun().forEach(file -> out().println("never run: " + file));
    }
    json.print(
        out(),
        Json.object(
            "classes", names,
            "bugs", without.bugs().size(),
            "reached", reached.length,
            "tried", tried,
            "found", counts.getOrDefault(Verdict.FOUND, 0),
            "survived", counts.getOrDefault(Verdict.SURVIVED, 0),
            "refused", counts.getOrDefault(Verdict.REFUSED, 0),
            "never_run", without.neverRun()),
        List.of(
            "%d classes (%s): %d bugs, %d of them on lines that a run reaches"
                .formatted(without.classes(), names, without.bugs().size(), reached.length),
            "%d bugs tried with seeds %s: %d found, %d survived, %d refused by the JVM"
                .formatted(
                    tried,
                    seeds,
                    counts.getOrDefault(Verdict.FOUND, 0),
                    counts.getOrDefault(Verdict.SURVIVED, 0),
                    counts.getOrDefault(Verdict.REFUSED, 0))));
    return tried == planned && planned > 0 ? ExitStatus.GOOD : ExitStatus.NOT_DECIDED;
  }

  /** A line for a bug; as text, only if it was not found. */
  private void print(Tried one) {
    if (json.isOn()) {
      out()
          .println(
              Json.line(
                  Json.object(
                      "bug",
                      one.text(),
                      "verdict",
                      one.verdict().name().toLowerCase(Locale.ROOT),
                      "why",
                      one.why())));
    } else if (one.verdict() != Verdict.FOUND) {
      out()
          .println(
              one.verdict() == Verdict.SURVIVED
                  ? "survived: " + one.text()
                  : "refused by the JVM: " + one.text());
    }
  }
}
