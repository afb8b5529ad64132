package org.starl.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.starl.apps.Demos;

/**
 * The output of a command line, and its exit status.
 *
 * @param out lines on standard output
 * @param err lines on standard error
 */
record Cli(int status, List<String> out, List<String> err) {

  static Cli run(String... args) {
    return run(Main.ALL, args);
  }

  static Cli run(Demos demos, String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status = Main.run(demos, new PrintWriter(out), new PrintWriter(err), args);
    return new Cli(status, out.toString().lines().toList(), err.toString().lines().toList());
  }

  String text() {
    return String.join("\n", out);
  }
}
