package org.starl.cli.lang;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.lang.server.StarlServer;
import picocli.CommandLine.Command;

/** {@code starl language-server}. */
@Command(
    name = "language-server",
    description = {
      "Serves an editor that speaks the Language Server Protocol on its input and output: errors of"
          + " .starl files while they are written, types, and the way to declarations.",
      "An editor starts it; docs/language.md says how to set one up."
    },
    footer = {"", "Example: starl language-server"})
public final class LanguageServerCommand extends BaseCommand implements Callable<Integer> {

  @Override
  public Integer call() throws InterruptedException {
    return StarlServer.serve(System.in, new FileOutputStream(FileDescriptor.out));
  }
}
