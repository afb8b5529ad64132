package org.starl.sim.record;

/** The time of a picture. */
public sealed interface PictureTime {

  /** A time in ns from the start of the run; its end if the run ends earlier. */
  record At(long timeNs) implements PictureTime {}

  /** The end of the run. */
  record End() implements PictureTime {}

  /** The first violation of a specification; no picture if there is none. */
  record Violation() implements PictureTime {}

  /**
   * In a bad run what went wrong; otherwise the first whole second with the greatest {@link
   * Layer#interest}.
   */
  record Best() implements PictureTime {}
}
