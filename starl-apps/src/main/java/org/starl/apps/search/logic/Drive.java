package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;

/** Drives to one place after another in reach tubes, with as much patience as it is told. Strand only. */
final class Drive {

  private static final long NS_PER_MS = 1_000_000;

  /** A motion that fails, by a bump say, is begun again so often. */
  private static final int RESTARTS = 3;

  /** Places are cells: a way between two tubes need not lead over their middles. */
  private static final double ROUGH_MM = House.CELL_MM / 2.0;

  private final GlobalVarHolder gvh;
  private final DistributedPathPlanning paths;
  private Point target = new Point(0, 0);
  private long patienceNs;
  private long waitingSinceNs;
  private int restarts;
  private boolean blocked;

  /** How a drive stands. */
  enum State {
    UNDER_WAY,
    THERE,
    /** It stands somewhere on the way. */
    BLOCKED
  }

  Drive(GlobalVarHolder gvh, DistributedPathPlanning paths) {
    this.gvh = gvh;
    this.paths = paths;
  }

  /**
   * Sets out, in place of whatever it did before.
   *
   * @param patienceMs so long it waits for a way that is free; on its way it is not held up any more
   */
  void to(Point place, long patienceMs) {
    stop();
    target = place;
    patienceNs = patienceMs * NS_PER_MS;
    restarts = 0;
    blocked = false;
    begin();
  }

  void stop() {
    paths.stop();
  }

  /** Where it is going, or went last. */
  Point target() {
    return target;
  }

  /** Those of a house's places to which no way leads now past what others hold, as far as is known. */
  BitSet barred(House house) {
    BitSet open = house.places();
    for (Capsule capsule : paths.taken()) {
      house.bar(capsule.axis(), capsule.radiusMm() + paths.radiusMm() - ROUGH_MM, open);
    }
    BitSet barred = house.places();
    barred.andNot(house.reachable(gvh.gps.pose().at(), open));
    return barred;
  }

  /** Looks how it stands; to be called every period. */
  State look() {
    if (blocked) {
      return State.BLOCKED;
    }
    TubeFlag flag = paths.tubeflag().get();
    switch (flag) {
      case DONE -> {
        return State.THERE;
      }
      case PLANNING, CLAIMING -> {
        if (gvh.plat.clock.nowNs() - waitingSinceNs > patienceNs) {
          stop();
          blocked = true;
        }
      }
      case MOVING -> waitingSinceNs = gvh.plat.clock.nowNs();
      case FAIL, IDLE -> {
        if (paths.failure().get() == TubeFailure.MOTION && restarts < RESTARTS) {
          restarts++;
          begin();
        } else {
          blocked = true;
        }
      }
    }
    return blocked ? State.BLOCKED : State.UNDER_WAY;
  }

  private void begin() {
    waitingSinceNs = gvh.plat.clock.nowNs();
    paths.goTo(new ItemPosition("place", target.xMm(), target.yMm()));
  }
}
