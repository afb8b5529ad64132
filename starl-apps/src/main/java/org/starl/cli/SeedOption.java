package org.starl.cli;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The seed of a command that makes one run. */
final class SeedOption {

  @Option(names = "--seed", paramLabel = "S", description = "Drawn and printed unless given.")
  private @Nullable String seed;

  /** The seed that was given; else another at each call. */
  long value() {
    return Seeds.of(seed);
  }
}
