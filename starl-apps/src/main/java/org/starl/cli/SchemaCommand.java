package org.starl.cli;

import java.io.PrintWriter;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code starl schema}. */
@Command(
    name = "schema",
    description =
        "The JSON schema of scenario files: editors complete and check a file that begins with"
            + " '# yaml-language-server: $$schema=FILE'.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl schema > scenario.schema.json"})
final class SchemaCommand implements Runnable {

  @Spec private @Nullable CommandSpec spec;

  @Override
  public void run() {
    CommandSpec here = Objects.requireNonNull(spec);
    PrintWriter out = here.commandLine().getOut();
    out.println(Json.lines(new ScenarioSchema(Main.demos(here)).json()));
  }
}
