package org.starl.sim.world;

import java.util.function.BooleanSupplier;
import org.starl.platform.Strand;

/** Runs posted actions at once; for tests without waits. */
final class DirectStrand implements Strand {

  @Override
  public void start(Runnable app) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void post(Runnable action) {
    action.run();
  }

  @Override
  public boolean isCurrent() {
    return true;
  }

  @Override
  public void sleepUntil(long atNs) {
    throw new UnsupportedOperationException();
  }

  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    throw new UnsupportedOperationException();
  }
}
