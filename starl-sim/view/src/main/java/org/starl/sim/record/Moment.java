package org.starl.sim.record;

/** When a picture is taken. */
public sealed interface Moment {

  /** At a time, in ns from the start of the run; at its end if that comes before. */
  record At(long timeNs) implements Moment {}

  /** At the end of the run. */
  record End() implements Moment {}

  /** When a specification is found violated first; never if all hold. */
  record Violation() implements Moment {}

  /** At the first whole second at which the layer sees most. */
  record Best() implements Moment {}
}
