package org.starl.cli;

import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The seed of a command that makes one run. */
final class SeedOption {

  @Option(names = "--seed", paramLabel = "S", description = "Drawn and printed unless given.")
  private @Nullable String seed;

  /**
   * A run that is over has its seed.
   *
   * @throws BadInput if one was given
   */
  void requireNoneFor(String trace) {
    if (seed != null) {
      throw new BadInput("--seed: " + trace + " is a run that is over; expected no seed");
    }
  }

  /** The seed that was given; else another at each call. */
  long value() {
    return Seeds.of(seed);
  }
}
