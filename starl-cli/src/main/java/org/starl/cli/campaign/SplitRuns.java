package org.starl.cli.campaign;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentSkipListMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.Redraws;
import org.starl.sim.Setting;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.ErrorRate;
import org.starl.sim.check.Levels;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.Splitting;
import org.starl.sim.kernel.CarrierKind;

/** A campaign whose runs split at levels, for bad runs that are rare. */
final class SplitRuns {

  private static final double CONFIDENCE = 0.95;

  private final RunRequest request;
  private final Seeds.Range seeds;
  private final List<String> levels;
  private final Splitting splitting;
  private final Map<Long, Splitting.Tree> trees = new ConcurrentSkipListMap<>();

  /**
   * @param names of the levels, with commas between them
   * @param copies text of the number of runs after a level
   * @throws BadInput if a text is wrong, or the request has redraws already
   */
  SplitRuns(RunRequest request, Seeds.Range seeds, String names, String copies) {
    this.request = request;
    this.seeds = seeds;
    levels = Arrays.stream(names.split(",", -1)).map(String::strip).toList();
    OptionValues.read("--split", names, any -> new Levels(levels));
    int count = OptionValues.whole("--copies", copies, 2, 1000);
    if (request.settings().has(Setting.REDRAWS)) {
      throw new BadInput("--split cannot be used with the setting redraws");
    }
    try {
      splitting = new Splitting(levels.size(), count);
    } catch (IllegalArgumentException tooMany) {
      throw new BadInput("--split: " + tooMany.getMessage());
    }
  }

  /** Runs all seeds and prints the estimate; returns the exit status. */
  int run(BaseCommand command, int workers, boolean isJson) throws InterruptedException {
    CarrierKind carriers = Carriers.select(null, command.err());
    ProgressLine progress = command.progress("seeds");
    new Campaign(seeds.first(), seeds.last(), workers, false)
        .run(
            seed -> {
              Splitting.Tree tree =
                  splitting.run(seed, (any, redraws) -> sample(seed, redraws, carriers));
              trees.put(seed, tree);
              return tree.first() == null
                  ? RunOutcome.good(new TreeMap<>())
                  : tree.first().outcome();
            },
            progress);
    progress.end();
    return print(command.out(), command.err(), isJson);
  }

  private Splitting.Sample sample(long seed, Redraws redraws, CarrierKind carriers) {
    Plan plan = SeedRuns.plan(with(redraws), seed, carriers);
    Levels reached = new Levels(levels);
    plan.simulation().observer(reached);
    RunOutcome outcome;
    try {
      outcome = RunOutcome.of(plan.simulation().build().run());
    } catch (RuntimeException failed) {
      outcome = RunOutcome.failed(failed);
    }
    return new Splitting.Sample(outcome, reached.atNs());
  }

  private RunRequest with(Redraws redraws) {
    return redraws.all().isEmpty() ? request : request.with(redraws);
  }

  private int print(PrintWriter out, PrintWriter err, boolean isJson) {
    double sum = 0;
    double squares = 0;
    long runs = 0;
    long bad = 0;
    long[] reached = new long[levels.size()];
    for (Splitting.Tree tree : trees.values()) {
      sum += tree.bad();
      squares += tree.bad() * tree.bad();
      runs += tree.runs();
      bad += tree.first() == null ? 0 : 1;
      for (int level = 0; level < tree.levels(); level++) {
        reached[level]++;
      }
    }
    ErrorRate.Estimate rate = ErrorRate.between(sum, squares, trees.size(), CONFIDENCE);
    if (isJson) {
      out.println(Json.line(summary(rate, runs, bad, reached)));
    } else {
      out.println(
          "%s: %,d seeds, %,d runs, %d copies at each level"
              .formatted(request.demo().name(), seeds.size(), runs, splitting.copies()));
      for (int level = 0; level < reached.length; level++) {
        out.println("  level %d: reached by %,d seeds".formatted(level + 1, reached[level]));
      }
      out.println(
          "bad runs: %,d of %,d seeds have one; probability %s, from %s to %s at 95 %%"
              .formatted(
                  bad,
                  seeds.size(),
                  ErrorRate.text(rate.mean()),
                  ErrorRate.text(rate.low()),
                  ErrorRate.text(rate.high())));
    }
    for (Map.Entry<Long, Splitting.Tree> entry : trees.entrySet()) {
      Splitting.@Nullable Bad first = entry.getValue().first();
      if (first != null) {
        err.println("seed " + entry.getKey() + ": " + first.outcome().detail());
        err.println("replay: " + with(first.redraws()).replay(entry.getKey()));
        return ExitStatus.VIOLATED;
      }
    }
    return ExitStatus.GOOD;
  }

  private Map<String, Object> summary(
      ErrorRate.Estimate rate, long runs, long bad, long[] reached) {
    Map<String, Object> summary = new LinkedHashMap<>();
    summary.put("app", request.demo().name());
    summary.put("seeds", seeds.first() + ".." + seeds.last());
    summary.put("split", levels);
    summary.put("copies", splitting.copies());
    summary.put("runs", runs);
    summary.put("reached", Arrays.stream(reached).boxed().toList());
    summary.put("bad_seeds", bad);
    summary.put("probability", rate.mean());
    summary.put("from", rate.low());
    summary.put("to", rate.high());
    return summary;
  }
}
