package org.starl.robot.optitrack;

import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.platform.Positioning;
import org.starl.platform.Strand;

/** Posts one body's fixes to a robot's strand; if the strand is late, only the newest. */
final class StrandPositioning implements Positioning {

  private final Strand strand;
  private final String name;
  private final AtomicReference<@Nullable Fix> waiting = new AtomicReference<>();
  private volatile @Nullable Receiver receiver;

  StrandPositioning(Strand strand, String name) {
    this.strand = strand;
    this.name = name;
  }

  @Override
  public void onFix(Receiver newReceiver) {
    if (receiver != null) {
      throw new IllegalStateException("the positioning of " + name + " has a receiver already");
    }
    receiver = newReceiver;
  }

  /** From any thread; without a receiver a fix is lost. */
  void offer(Fix fix) {
    if (receiver != null && waiting.getAndSet(fix) == null) {
      strand.post(this::deliver);
    }
  }

  private void deliver() {
    Fix fix = waiting.getAndSet(null);
    Receiver to = receiver;
    if (fix != null && to != null) {
      to.fixed(fix);
    }
  }
}
