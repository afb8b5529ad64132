package org.starl.robot.realtime;

import org.starl.platform.Timer;

/** A timer of a strand: is its own alarm, so that setting it allocates nothing. */
final class RealTimer extends Alarm implements Timer {

  private final RealStrand strand;
  private final Runnable action;

  RealTimer(RealStrand strand, Runnable action) {
    this.strand = strand;
    this.action = action;
  }

  @Override
  public void set(long atNs) {
    strand.set(this, atNs);
  }

  @Override
  public void cancel() {
    strand.cancel(this);
  }

  @Override
  public boolean isSet() {
    return strand.isSet(this);
  }

  @Override
  void ring() {
    action.run();
  }
}
