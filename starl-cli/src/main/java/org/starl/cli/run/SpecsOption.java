package org.starl.cli.run;

import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.Simulation;
import org.starl.spec.Specs;
import picocli.CommandLine.Option;

/** The option that says which specifications a run checks. */
final class SpecsOption {

  @Option(
      names = "--specs",
      paramLabel = "WHICH",
      description =
          "Specifications to check: off, safety (all but those that require something in time) or"
              + " all (default: all).")
  private @Nullable Specs specs;

  void apply(Simulation.Builder simulation) {
    if (specs != null) {
      simulation.specs(specs);
    }
  }

  /**
   * Checks the option for runs that check all their specifications.
   *
   * @throws BadInput if it was given
   */
  void requireNoneFor(String what) {
    if (specs != null) {
      throw new BadInput("--specs cannot be used with " + what);
    }
  }
}
