package org.starl.cli;

import java.io.PrintWriter;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The context of a command: its writers, and the apps that the command line knows. */
abstract class BaseCommand {

  @Spec private @Nullable CommandSpec spec;

  final CommandSpec spec() {
    return Objects.requireNonNull(spec);
  }

  final PrintWriter out() {
    return spec().commandLine().getOut();
  }

  final PrintWriter err() {
    return spec().commandLine().getErr();
  }

  final Demos demos() {
    return ((Main) spec().root().userObject()).demos();
  }
}
