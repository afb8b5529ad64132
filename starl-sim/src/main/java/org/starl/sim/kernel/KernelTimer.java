package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;
import org.starl.platform.Timer;

/** A timer of a strand or of the world; it has at most one event in the queue. */
final class KernelTimer implements Timer, Runnable {

  private final Kernel kernel;
  private final @Nullable SimStrand strand;
  private final Runnable action;
  private int slot = EventTable.NONE;

  KernelTimer(Kernel kernel, @Nullable SimStrand strand, Runnable action) {
    this.kernel = kernel;
    this.strand = strand;
    this.action = action;
  }

  @Override
  public void set(long atNs) {
    if (isDead()) {
      return;
    }
    cancel();
    slot = kernel.add(Math.max(atNs, kernel.nowNs()), strand, this);
  }

  @Override
  public void cancel() {
    if (isSet()) {
      kernel.queue.remove(slot);
      slot = EventTable.NONE;
    }
  }

  @Override
  public boolean isSet() {
    return slot != EventTable.NONE && !isDead();
  }

  /** Runs as an event of the kernel. */
  @Override
  public void run() {
    slot = EventTable.NONE;
    action.run();
  }

  // The queue drops the events of a closed strand, and may have reused the slot since.
  private boolean isDead() {
    return strand != null && strand.isClosed();
  }
}
