package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;
import org.starl.platform.Timer;

/** A timer of a strand or of the world; it has at most one event in the queue. */
final class KernelTimer implements Timer, Prefetchable {

  private final Kernel kernel;
  private final @Nullable SimStrand strand;
  private final Runnable action;
  private int slot;
  // NEVER while it is not set.
  private long atNs = NEVER;

  KernelTimer(Kernel kernel, @Nullable SimStrand strand, Runnable action) {
    this.kernel = kernel;
    this.strand = strand;
    this.action = action;
  }

  @Override
  public void set(long newAtNs) {
    if (newAtNs == atNs || isDead()) {
      return;
    }
    cancel();
    if (newAtNs != NEVER) {
      atNs = newAtNs;
      slot = kernel.add(Math.max(newAtNs, kernel.nowNs()), strand, this);
    }
  }

  @Override
  public void cancel() {
    if (isSet()) {
      kernel.queue.remove(slot);
      atNs = NEVER;
    }
  }

  @Override
  public boolean isSet() {
    return atNs != NEVER && !isDead();
  }

  @Override
  public int prefetch() {
    return Cache.prefetch(action);
  }

  /** Runs as an event of the kernel. */
  @Override
  public void run() {
    atNs = NEVER;
    action.run();
  }

  // The queue drops the events of a closed strand, and may have reused the slot since.
  private boolean isDead() {
    return strand != null && strand.isClosed();
  }
}
