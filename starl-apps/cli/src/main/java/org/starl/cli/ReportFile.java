package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.function.LongFunction;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.cli.report.Claims;
import org.starl.cli.report.MessageCounts;
import org.starl.cli.report.Pictured;
import org.starl.cli.report.Report;
import org.starl.cli.report.RunFacts;
import org.starl.cli.report.Subject;
import org.starl.input.BadInput;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.CampaignResult.Run;

/**
 * The page about a campaign, if the user asked for one: collects what it needs of each run, on any
 * thread, and is written whole once all is over, or not at all.
 */
final class ReportFile implements Closeable {

  private static final String OPTION = "--report";

  /** Of each run some kilobytes are kept. */
  private static final int MOST_RUNS = 100_000;

  private final OutputFile file;
  private final long first;
  private final BySeed<RunFacts> bySeed;

  private ReportFile(String name, Seeds.Range range) {
    if (range.last() - range.first() >= MOST_RUNS) {
      throw new BadInput(
          OPTION + ": a report of more than " + MOST_RUNS + " runs: expected fewer seeds");
    }
    first = range.first();
    bySeed = new BySeed<>(range);
    file = new OutputFile(OPTION, name);
  }

  /**
   * Null if the user asked for none.
   *
   * @throws BadInput if it cannot be written
   */
  static @Nullable ReportFile of(@Nullable String name, Seeds.Range range) {
    return name == null ? null : new ReportFile(name, range);
  }

  /** Counts the messages of a run that is about to be built. */
  static MessageCounts watch(Plan plan) {
    MessageCounts messages = new MessageCounts();
    plan.simulation().observer(messages);
    return messages;
  }

  void put(long seed, SimResult result, Plan plan, MessageCounts messages) {
    bySeed.put(seed, RunFacts.of(result, plan.story(), messages));
  }

  /**
   * Writes the page; runs some seeds again for their pictures.
   *
   * @param plans a run each, with carriers
   */
  void write(
      Subject subject,
      CampaignResult result,
      LongFunction<Plan> plans,
      List<String> shrunk,
      PrintWriter err)
      throws IOException {
    SortedMap<Long, RunFacts> facts = Report.facts(result, bySeed::get);
    List<Run> runs = Report.toPicture(result);
    List<Pictured> pictured = new ArrayList<>();
    if (!runs.isEmpty()) {
      ProgressLine progress = new ProgressLine(err, "runs taken again with pictures");
      for (Run run : runs) {
        long momentNs = Report.momentNs(run, facts.get(run.seed()));
        pictured.add(Pictured.of(run.seed(), plans, momentNs));
        progress.show(pictured.size(), runs.size());
      }
      progress.end();
    }
    Pictured example = runs.isEmpty() ? Pictured.best(first, plans) : null;
    Claims claims = Claims.of(plans.apply(first));
    Report report = new Report(subject, result, facts, claims, example, pictured, shrunk);
    file.stream().write(report.page().getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void close() throws IOException {
    file.close();
  }

  /** What is run, for the head of the page. */
  static Subject subject(RunRequest chosen, String command, Seeds.Range range) {
    Map<String, String> given = new LinkedHashMap<>();
    for (Parameter parameter : chosen.demo().parameters()) {
      String value = chosen.parameters().get(parameter.key());
      if (value != null && !value.equals(parameter.defaultValue())) {
        given.put(parameter.key(), value);
      }
    }
    List<String> faults = new ArrayList<>();
    chosen.settings().get(Setting.FAULTS).faults().forEach(fault -> faults.add(fault.toString()));
    chosen
        .settings()
        .given()
        .forEach((setting, value) -> {
          if (setting == Setting.CHAOS) {
            faults.add(setting.key() + ": " + value);
          } else if (setting != Setting.FAULTS) {
            given.put(setting.key(), value);
          }
        });
    Map<String, String> settings = new LinkedHashMap<>(chosen.parameters());
    settings.putAll(chosen.plan(range.first()).simulation().settings().asText());
    return new Subject(
        chosen.demo().name(),
        chosen.demo().summary(),
        command,
        range.first() + ".." + range.last(),
        faults,
        given,
        settings,
        chosen::replay);
  }
}
