package org.starl.sim.kernel;

/** A piece that knows which objects it will use. */
public interface Touchable extends Runnable {

  /** Prefetches the objects that {@link #run} will use ({@link Cache}); has no other effect. */
  int touch();
}
