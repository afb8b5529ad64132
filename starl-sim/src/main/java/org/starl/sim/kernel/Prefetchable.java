package org.starl.sim.kernel;

/** A piece that can prefetch the objects it will use. */
public interface Prefetchable extends Runnable {

  /** Prefetches the objects that {@link #run} will use ({@link Cache}); has no other effect. */
  int prefetch();
}
