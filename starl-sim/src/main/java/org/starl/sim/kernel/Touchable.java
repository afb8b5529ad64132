package org.starl.sim.kernel;

/** A piece that knows what it is going to use. */
public interface Touchable extends Runnable {

  /** Touches what {@link #run} is going to use ({@link Cache}); changes nothing. */
  int touch();
}
