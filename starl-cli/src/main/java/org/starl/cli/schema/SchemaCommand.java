package org.starl.cli.schema;

import java.io.PrintWriter;
import org.starl.apps.Demos;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Json;
import org.starl.input.BadInput;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code starl schema}. */
@Command(
    name = "schema",
    description =
        "Prints the JSON schema of scenario files, sweeps or deployment files. Editors use it to"
            + " complete and check a file that begins with '# yaml-language-server:"
            + " $$schema=FILE'.",
    footer = {
      "",
      "Example: starl schema > scenario.schema.json",
      "         starl schema deployment > deployment.schema.json"
    })
public final class SchemaCommand extends BaseCommand implements Runnable {

  private static final String SCENARIO = "scenario";
  private static final String SWEEP = "sweep";
  private static final String DEPLOYMENT = "deployment";

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "KIND",
      defaultValue = SCENARIO,
      description = "scenario, sweep or deployment (default: ${DEFAULT-VALUE}).")
  private String kind = SCENARIO;

  @Override
  public void run() {
    PrintWriter out = out();
    Demos demos = demos();
    out.println(
        Json.lines(
            switch (kind) {
              case SCENARIO -> ScenarioSchema.json(demos);
              case SWEEP -> SweepSchema.json(demos);
              case DEPLOYMENT -> DeploymentSchema.json(demos);
              default ->
                  throw new BadInput(
                      BadInput.quote(kind) + ": expected one of scenario, sweep, deployment");
            }));
  }
}
