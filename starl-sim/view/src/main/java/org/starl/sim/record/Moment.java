package org.starl.sim.record;

/** The time of a picture. */
public sealed interface Moment {

  /** A time in ns from the start of the run; its end if the run ends earlier. */
  record At(long timeNs) implements Moment {}

  /** The end of the run. */
  record End() implements Moment {}

  /** The first violation of a specification; no picture if there is none. */
  record Violation() implements Moment {}

  /** The first whole second with the greatest {@link Layer#interest}. */
  record Best() implements Moment {}
}
