package org.starl.cli.command;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;

/** The option for machine-readable output. */
public final class JsonOption {

  @Option(names = "--json", description = "Print JSON, one object per line, instead of text.")
  private boolean json;

  public boolean isOn() {
    return json;
  }

  /** Prints the object as JSON, or the lines as text. */
  public void print(PrintWriter out, Map<String, ?> object, List<String> lines) {
    if (json) {
      out.println(Json.line(object));
    } else {
      lines.forEach(out::println);
    }
  }
}
