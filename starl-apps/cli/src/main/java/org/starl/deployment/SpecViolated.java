package org.starl.deployment;

import org.starl.spec.SpecReport.Violation;

/** A robot has violated a specification, and must not go on. */
final class SpecViolated extends RuntimeException {

  private static final long serialVersionUID = 1L;

  SpecViolated(Violation violation) {
    super("VIOLATED: " + violation);
  }
}
