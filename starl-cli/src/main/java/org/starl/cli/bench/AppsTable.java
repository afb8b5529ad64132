package org.starl.cli.bench;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Input;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.Setting;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.kernel.CarrierKind;

/**
 * {@code starl bench apps}: a campaign of each app on each of its {@link Demo#inputs}, without loss
 * and with 20 % loss. Prints a table in Markdown, for the docs.
 */
public final class AppsTable {

  /** The workload's name. */
  public static final String NAME = "apps";

  /** One line for {@code starl list}. */
  public static final String SUMMARY =
      "every app on every input of a folder, with and without loss: a table in Markdown";

  private static final double LOSS = 0.2;

  private static final List<String> HEAD =
      List.of(
          "| app | input | messages lost | seeds | good | violations"
              + " | simulated s, median (most) | messages, median"
              + " | collisions of robots, median (most) | the code of 2014 |",
          "|---|---|---|---|---|---|---|---|---|---|");

  /** The result of one campaign. */
  private record Row(Demo demo, Input input, boolean isLossy, CampaignResult result) {

    String markdown() {
      return String.format(
          Locale.ROOT,
          "| %s | %s | %s | %d | %d | %d | %.0f (%.0f) | %.0f | %.0f (%.0f) | %s |",
          demo.name(),
          input.name(),
          isLossy ? "20 %" : "none",
          result.runs().size(),
          result.count(Verdict.GOOD),
          result.count(Verdict.VIOLATED),
          figure("end_s", 50),
          figure("end_s", 100),
          figure("datagrams_sent", 50),
          figure("robots_collided", 50),
          figure("robots_collided", 100),
          input.original());
    }

    Map<String, Object> json() {
      Map<String, Object> json = new LinkedHashMap<>();
      json.put("app", demo.name());
      json.put("input", input.name());
      json.put("loss", isLossy ? LOSS : 0.0);
      json.put("runs", result.runs().size());
      for (Verdict verdict : Verdict.values()) {
        json.put(verdict.name().toLowerCase(Locale.ROOT), result.count(verdict));
      }
      for (String figure : result.figures()) {
        json.put(figure + "_p50", figure(figure, 50));
        json.put(figure + "_most", figure(figure, 100));
      }
      return json;
    }

    private double figure(String name, int percent) {
      return result.samples(name) == 0 ? 0 : result.percentile(name, percent);
    }
  }

  private final Path data;
  private final Seeds.Range seeds;
  private final CarrierKind carriers;
  private final PrintWriter out;
  private final PrintWriter err;
  private boolean isGood = true;

  /**
   * @param data the folder with the inputs
   */
  AppsTable(Path data, Seeds.Range seeds, CarrierKind carriers, PrintWriter out, PrintWriter err) {
    if (!Files.isDirectory(data)) {
      throw new BadInput("--inputs: " + data + ": expected a folder with the apps' input files");
    }
    this.data = data;
    this.seeds = seeds;
    this.carriers = carriers;
    this.out = out;
    this.err = err;
  }

  /**
   * Runs the campaigns; prints each row as soon as its campaign ends.
   *
   * @param onlyApp only this app; null for all apps
   * @param onlyInput only inputs of this name; null for all inputs
   * @return whether every run was good
   */
  boolean print(Demos demos, @Nullable String onlyApp, @Nullable String onlyInput, JsonOption json)
      throws InterruptedException {
    if (onlyApp != null && demos.byName(onlyApp).isEmpty()) {
      throw unknown("--app", onlyApp, demos.names());
    }
    Map<Input, Demo> inputs = new LinkedHashMap<>();
    for (Demo demo : demos.all()) {
      if (onlyApp == null || demo.name().equals(onlyApp)) {
        demo.inputs(data).forEach(input -> inputs.put(input, demo));
      }
    }
    Set<String> names = new TreeSet<>();
    inputs.keySet().forEach(input -> names.add(input.name()));
    if (onlyInput != null && !names.contains(onlyInput)) {
      throw unknown("--input", onlyInput, names);
    }
    inputs.keySet().removeIf(input -> onlyInput != null && !input.name().equals(onlyInput));
    if (!json.isOn()) {
      HEAD.forEach(out::println);
    }
    for (Map.Entry<Input, Demo> run : inputs.entrySet()) {
      if (!Files.exists(run.getKey().path())) {
        throw new BadInput(run.getKey().path() + ": missing input of " + run.getValue().name());
      }
      for (boolean isLossy : new boolean[] {false, true}) {
        Row row = row(run.getValue(), run.getKey(), isLossy);
        json.print(out, row.json(), List.of(row.markdown()));
        out.flush();
      }
    }
    return isGood;
  }

  private static BadInput unknown(String option, String value, Collection<String> names) {
    return new BadInput(option + ": " + BadInput.quote(value) + ": expected one of " + names);
  }

  private Row row(Demo demo, Input input, boolean isLossy) throws InterruptedException {
    RunRequest.Builder request = new RunRequest.Builder(demo);
    input.parameters().forEach((key, value) -> request.set("", key, value));
    if (isLossy) {
      request.set("", Setting.MESSAGE_LOSS.key(), Double.toString(LOSS));
    }
    RunRequest built = request.build();
    ProgressLine progress = new ProgressLine(err, "runs");
    CampaignResult result =
        new Campaign(seeds.first(), seeds.last()).run(seed -> run(built, seed), progress);
    progress.end();
    CampaignResult.Run bad = result.firstBad();
    if (bad != null) {
      isGood = false;
      err.println(demo.name() + ", seed " + bad.seed() + ": " + bad.outcome().detail());
      err.println("replay: " + built.replay(bad.seed()));
    }
    return new Row(demo, input, isLossy, result);
  }

  private RunOutcome run(RunRequest request, long seed) {
    return RunOutcome.of(request.plan(seed).simulation().carriers(carriers).build().run());
  }
}
