package org.starl.cli;

import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The seed of a command that makes one run. */
final class SeedOption {

  @Option(
      names = "--seed",
      paramLabel = "S",
      description = "Seed of the run (default: drawn, and printed).")
  private @Nullable String seed;

  /**
   * A trace has the seed of its run.
   *
   * @throws BadInput if a seed was given
   */
  void requireNoneFor(String trace) {
    if (seed != null) {
      throw new BadInput("--seed cannot be used with a trace: " + trace);
    }
  }

  /** The seed that was given, else a random one, another at each call. */
  long value() {
    return Seeds.of(seed);
  }
}
