package org.starl.sim.world;

import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Strand;
import org.starl.platform.SuspendedApp;

/** Runs posted actions at once; for tests without waits. */
final class DirectStrand implements Strand {

  @Override
  public void start(Runnable app) {
    throw new UnsupportedOperationException();
  }

  @Override
  public void start(SuspendedApp app) {
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

  @Override
  public boolean suspendUntil(
      @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
    throw new UnsupportedOperationException();
  }
}
