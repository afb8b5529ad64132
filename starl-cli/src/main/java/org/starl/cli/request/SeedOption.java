package org.starl.cli.request;

import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import picocli.CommandLine.Option;

/** The seed option of commands that make one run. */
public final class SeedOption {

  @Option(
      names = "--seed",
      paramLabel = "S",
      description = "Seed of the run (default: a random seed, which is printed).")
  private @Nullable String seed;

  /**
   * Checks the option for a trace, which has the seed of its run.
   *
   * @throws BadInput if a seed was given
   */
  public void requireNoneFor(String trace) {
    if (seed != null) {
      throw new BadInput("--seed cannot be used with a trace: " + trace);
    }
  }

  /**
   * Checks the option for work of several processes: each must have the same seed.
   *
   * @throws BadInput if no seed is given
   */
  public void requireGiven() {
    if (seed == null) {
      throw new BadInput("--out and --print-job need --seed S, the same for all shards");
    }
  }

  /** The given seed, or else a random seed, a new one at each call. */
  public long value() {
    return Seeds.of(seed);
  }
}
