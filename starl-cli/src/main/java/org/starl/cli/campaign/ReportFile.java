package org.starl.cli.campaign;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.LongFunction;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.OutputFile;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.report.CampaignDescription;
import org.starl.cli.report.IllustratedRun;
import org.starl.cli.report.Page;
import org.starl.cli.report.Report;
import org.starl.cli.report.RunFacts;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.Setting;
import org.starl.sim.SimulationPlan;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;

/**
 * The report page of a campaign. It collects the row of each run. After the campaign it writes the
 * page completely or not at all.
 */
final class ReportFile implements Closeable {

  private static final String OPTION = "--report";

  /** The report keeps some kilobytes for each run. */
  private static final int MAX_RUNS = 100_000;

  private final OutputFile file;
  private final long first;
  private final List<Run> runs = new ArrayList<>();
  private final SortedMap<Long, RunFacts> facts = new TreeMap<>();

  private ReportFile(String name, Seeds.Range range) {
    if (range.last() - range.first() >= MAX_RUNS) {
      throw new BadInput(
          OPTION + ": a report of more than " + MAX_RUNS + " runs: expected fewer seeds");
    }
    first = range.first();
    file = new OutputFile(OPTION, name);
  }

  /**
   * The file of that name; null without a name.
   *
   * @throws BadInput if it cannot be written
   */
  static @Nullable ReportFile of(@Nullable String name, Seeds.Range range) {
    return name == null ? null : new ReportFile(name, range);
  }

  /** Adds the next run in seed order. */
  void add(SeedRow row) {
    runs.add(new Run(row.seed(), row.outcome()));
    if (row.facts() != null) {
      facts.put(row.seed(), row.facts());
    }
  }

  /**
   * Writes the page. Runs some seeds again for their pictures, until a signal stops the command:
   * the process ends soon, and the page must be complete by then.
   *
   * @param tally the sums over the same rows
   * @param steered the steered runs
   * @param plans makes the plan of a seed, including its carriers
   */
  void write(
      CampaignDescription description,
      LongFunction<Plan> plans,
      List<String> shrunk,
      SteeredRuns steered,
      CampaignTally tally,
      BaseCommand command)
      throws IOException {
    CampaignResult result = new CampaignResult(runs);
    List<Run> shown = Report.toIllustrate(result);
    List<IllustratedRun> illustrated = new ArrayList<>();
    if (!shown.isEmpty()) {
      ProgressLine progress = new ProgressLine(command.err(), "bad runs repeated for pictures");
      for (Run run : shown) {
        if (command.stop().isStopped()) {
          break;
        }
        long momentNs = Report.momentNs(run, facts.get(run.seed()));
        illustrated.add(IllustratedRun.of(run.seed(), plans, momentNs));
        progress.show(illustrated.size(), shown.size());
      }
      progress.end();
      if (illustrated.size() < shown.size()) {
        command
            .err()
            .println(
                "interrupted: the report has pictures of %d of %d bad runs"
                    .formatted(illustrated.size(), shown.size()));
      }
    }
    IllustratedRun example = shown.isEmpty() ? IllustratedRun.best(first, plans) : null;
    SimulationPlan plan = plans.apply(first).simulation().build().plan();
    List<Monitor> monitors = Monitors.of(plan.monitors()).monitors();
    Report report =
        new Report(
            description,
            result,
            facts,
            tally.chances(),
            tally.coverage(),
            monitors,
            example,
            illustrated,
            shrunk,
            steered.story(),
            steered.replay());
    file.stream().write(new Page(report).write().getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void close() throws IOException {
    file.close();
  }

  /** The campaign, for the head of the page. */
  static CampaignDescription description(RunRequest request, String command, Seeds.Range range) {
    List<String> given = new ArrayList<>();
    for (Parameter parameter : request.demo().parameters()) {
      String value = request.parameters().get(parameter.key());
      if (value != null) {
        given.add(parameter.key() + "=" + value);
      }
    }
    List<String> faults = new ArrayList<>();
    request.settings().get(Setting.FAULTS).faults().forEach(fault -> faults.add(fault.toString()));
    request
        .settings()
        .given()
        .forEach((setting, value) -> {
          if (setting == Setting.CHAOS) {
            faults.add(setting.key() + ": " + value);
          } else if (setting != Setting.FAULTS) {
            given.add(setting.key() + "=" + value);
          }
        });
    Map<String, String> settings = new LinkedHashMap<>(request.demo().defaults());
    settings.putAll(request.parameters());
    settings.putAll(request.plan(range.first()).simulation().settings().asText());
    return new CampaignDescription(
        request.demo().name(),
        request.demo().summary(),
        command,
        range.first() + ".." + range.last(),
        faults,
        given,
        settings,
        request::replay,
        request::shrink);
  }
}
