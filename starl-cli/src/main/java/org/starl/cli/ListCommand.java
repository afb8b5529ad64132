package org.starl.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Scenario;
import org.starl.bench.CheckSpeed;
import org.starl.bench.CrossingRules;
import org.starl.bench.FleetRates;
import org.starl.bench.MutexCost;
import org.starl.bench.Workload;
import org.starl.cli.bench.AppsTable;
import org.starl.cli.bench.BenchCommand;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.request.RunRequest;
import org.starl.sim.Setting;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultGrammar;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code starl list}. */
@Command(
    name = "list",
    description =
        "Lists apps, primitives, scenarios, parameters, workloads, settings, faults and envelopes,"
            + " one per line. Of one app: its scenarios, parameters and specifications.",
    footer = {"", "Example: starl list", "         starl list intersection"})
final class ListCommand extends BaseCommand implements Runnable {

  private static final Map<String, String> HEADINGS =
      Map.of(
          "setting", "settings, for --set and scenario files:",
          "fault",
              "faults, for --fault and 'faults: [..]'; "
                  + FaultGrammar.TIMES
                  + "; WHO is a name, names (bot0+bot1), any, half or all:",
          "envelope", "envelopes, for --set chaos=NAME; --chaos uses the app's own:");

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "APP|PRIMITIVE",
      description = "Only this one, with what each of its specifications says.")
  private @Nullable String name;

  @Mixin private JsonOption json = new JsonOption();

  /**
   * A line of the list.
   *
   * @param kind app, primitive, scenario, parameter, lemma, bench, setting, fault or envelope
   * @param of the app of a scenario, parameter or lemma; else empty
   * @param defaultValue of a parameter or setting; else empty
   */
  private record Item(String kind, String of, String name, String defaultValue, String meaning) {

    String line() {
      return switch (kind) {
        case "app", "primitive", "bench" -> kind + " " + name + ": " + meaning;
        case "scenario", "lemma" -> "  " + kind + " " + name + ": " + meaning;
        case "fault", "envelope" -> "  " + name + "  " + meaning;
        default -> "  " + name + "=" + defaultValue + "  " + meaning;
      };
    }

    Map<String, String> json() {
      Map<String, String> json = new LinkedHashMap<>();
      json.put("kind", kind);
      if (!of.isEmpty()) {
        json.put("of", of);
      }
      json.put("name", name);
      if (kind.equals("parameter") || kind.equals("setting")) {
        json.put("default", defaultValue);
      }
      json.put("what", meaning);
      return json;
    }
  }

  @Override
  public void run() {
    PrintWriter out = out();
    String kind = "";
    for (Item item : name == null ? items(demos().all()) : items(demo(name))) {
      if (json.isOn()) {
        out.println(Json.line(item.json()));
        continue;
      }
      String heading = HEADINGS.get(item.kind());
      if (heading != null && !item.kind().equals(kind)) {
        out.println(heading);
      }
      kind = item.kind();
      out.println(item.line());
    }
  }

  private Demo demo(String app) {
    return RunRequest.Builder.of(demos(), app, "", "").build().demo();
  }

  /** Of one demo: what it is, and the specifications that its first seed's run checks. */
  private static List<Item> items(Demo demo) {
    List<Item> items = described(demo);
    Simulation simulation = new RunRequest.Builder(demo).build().plan(1).simulation().build();
    SpecReport report = Monitors.of(simulation.plan().monitors()).report();
    for (String lemma : report.lemmas()) {
      items.add(new Item("lemma", demo.name(), lemma, "", report.description(lemma)));
    }
    return items;
  }

  private static List<Item> described(Demo demo) {
    List<Item> items = new ArrayList<>();
    String app = demo.name();
    String kind = demo.kind().name().toLowerCase(Locale.ROOT);
    items.add(new Item(kind, "", app, "", demo.summary()));
    for (Scenario scenario : demo.scenarios()) {
      items.add(new Item("scenario", app, scenario.name(), "", scenario.what()));
    }
    for (Parameter p : demo.parameters()) {
      items.add(new Item("parameter", app, p.key(), p.defaultValue(), p.text()));
    }
    return items;
  }

  private static List<Item> items(List<Demo> demos) {
    List<Item> items = new ArrayList<>();
    demos.forEach(demo -> items.addAll(described(demo)));
    for (Workload workload : Workload.all()) {
      items.add(new Item("bench", "", workload.name(), "", workload.summary()));
    }
    items.add(new Item("bench", "", CrossingRules.NAME, "", CrossingRules.SUMMARY));
    items.add(new Item("bench", "", CheckSpeed.NAME, "", CheckSpeed.SUMMARY));
    items.add(new Item("bench", "", FleetRates.NAME, "", FleetRates.SUMMARY));
    items.add(new Item("bench", "", BenchCommand.VIEW, "", BenchCommand.VIEW_SUMMARY));
    items.add(new Item("bench", "", MutexCost.NAME, "", MutexCost.SUMMARY));
    items.add(new Item("bench", "", AppsTable.NAME, "", AppsTable.SUMMARY));
    for (Setting<?> setting : RunRequest.known()) {
      items.add(new Item("setting", "", setting.key(), setting.defaultText(), setting.meaning()));
    }
    for (FaultGrammar.Kind kind : FaultGrammar.kinds()) {
      items.add(new Item("fault", "", kind.usage(), "", kind.meaning()));
    }
    for (Envelope envelope : Envelope.values()) {
      items.add(new Item("envelope", "", envelope.toString(), "", envelope.meaning()));
    }
    return items;
  }
}
