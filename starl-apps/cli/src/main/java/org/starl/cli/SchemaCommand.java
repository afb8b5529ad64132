package org.starl.cli;

import java.io.PrintWriter;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.input.BadInput;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code starl schema}. */
@Command(
    name = "schema",
    description =
        "The JSON schema of scenario files, or of deployment files: editors complete and check a file that"
            + " begins with '# yaml-language-server: $$schema=FILE'.",
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Example: starl schema > scenario.schema.json",
      "         starl schema deployment > deployment.schema.json"
    })
final class SchemaCommand implements Runnable {

  private static final String SCENARIO = "scenario";
  private static final String DEPLOYMENT = "deployment";

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "KIND",
      description = "scenario, deployment; scenario unless given.")
  private String kind = SCENARIO;

  @Spec private @Nullable CommandSpec spec;

  @Override
  public void run() {
    CommandSpec here = Objects.requireNonNull(spec);
    PrintWriter out = here.commandLine().getOut();
    Demos demos = Main.demos(here);
    out.println(
        Json.lines(
            switch (kind) {
              case SCENARIO -> new ScenarioSchema(demos).json();
              case DEPLOYMENT -> new DeploymentSchema(demos).json();
              default ->
                  throw new BadInput(
                      BadInput.quote(kind) + ": expected one of scenario, deployment");
            }));
  }
}
