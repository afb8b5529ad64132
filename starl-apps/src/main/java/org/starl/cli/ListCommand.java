package org.starl.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Scenario;
import org.starl.bench.Workload;
import org.starl.bench.Workloads;
import org.starl.sim.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code starl list}. */
@Command(
    name = "list",
    description = "Apps with their scenarios and parameters, workloads, and settings: a line each.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl list"})
final class ListCommand implements Runnable {

  @Option(names = "--json", description = "Print one JSON object a line.")
  private boolean json;

  @Spec private @Nullable CommandSpec spec;

  /**
   * One thing that the command line knows by name.
   *
   * @param kind app, scenario, parameter, bench or setting
   * @param of the app that it belongs to, or empty
   * @param defaultValue of a parameter or setting
   */
  private record Item(String kind, String of, String name, String defaultValue, String what) {

    String line() {
      return switch (kind) {
        case "app", "bench" -> kind + " " + name + ": " + what;
        case "scenario" -> "  scenario " + name + ": " + what;
        default -> "  " + name + "=" + defaultValue + "  " + what;
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
      json.put("what", what);
      return json;
    }
  }

  @Override
  public void run() {
    CommandSpec here = Objects.requireNonNull(spec);
    PrintWriter out = here.commandLine().getOut();
    boolean settingsBegun = false;
    for (Item item : items(Main.demos(here).all())) {
      if (json) {
        out.println(Json.line(item.json()));
        continue;
      }
      if (item.kind().equals("setting") && !settingsBegun) {
        settingsBegun = true;
        out.println("settings, for --set and scenario files:");
      }
      out.println(item.line());
    }
  }

  private static List<Item> items(List<Demo> demos) {
    List<Item> items = new ArrayList<>();
    for (Demo demo : demos) {
      String app = demo.name();
      items.add(new Item("app", "", app, "", demo.summary()));
      for (Scenario scenario : demo.scenarios()) {
        items.add(new Item("scenario", app, scenario.name(), "", scenario.what()));
      }
      for (Parameter p : demo.parameters()) {
        items.add(new Item("parameter", app, p.key(), p.defaultValue(), p.what()));
      }
    }
    for (Workload workload : Workloads.all()) {
      items.add(new Item("bench", "", workload.name(), "", workload.summary()));
    }
    for (Setting<?> setting : Setting.all()) {
      items.add(new Item("setting", "", setting.key(), setting.defaultText(), setting.meaning()));
    }
    return items;
  }
}
