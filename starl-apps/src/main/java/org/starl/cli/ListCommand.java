package org.starl.cli;

import java.io.PrintWriter;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.bench.Workload;
import org.starl.bench.Workloads;
import org.starl.sim.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code starl list}. */
@Command(
    name = "list",
    description = "Apps with their parameters, workloads, and settings: a line each.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl list"})
final class ListCommand implements Runnable {

  @Spec private @Nullable CommandSpec spec;

  @Override
  public void run() {
    CommandSpec here = Objects.requireNonNull(spec);
    PrintWriter out = here.commandLine().getOut();
    for (Demo demo : Main.demos(here).all()) {
      out.println("app " + demo.name() + ": " + demo.summary());
      for (Parameter parameter : demo.parameters()) {
        out.println(line(parameter.key(), parameter.defaultValue(), parameter.what()));
      }
    }
    for (Workload workload : Workloads.all()) {
      out.println("bench " + workload.name() + ": " + workload.summary());
    }
    out.println("settings, for --set and scenario files:");
    for (Setting<?> setting : Setting.all()) {
      out.println(line(setting.key(), setting.defaultText(), setting.meaning()));
    }
  }

  private static String line(String key, String value, String what) {
    return "  " + key + "=" + value + "  " + what;
  }
}
