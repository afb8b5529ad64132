package org.starl.cli;

import picocli.CommandLine.Option;

/** For programs that read what the command prints. */
final class JsonOption {

  @Option(names = "--json", description = "Print JSON, one object a line, instead of text.")
  private boolean json;

  boolean isOn() {
    return json;
  }
}
