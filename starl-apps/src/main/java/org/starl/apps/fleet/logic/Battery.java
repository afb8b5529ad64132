package org.starl.apps.fleet.logic;

import org.starl.GlobalVarHolder;
import org.starl.Persistent;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.shape.Shapes;

/**
 * A battery as the program keeps account of it: its charge falls with way and time, and grows at a charger.
 * Strand only.
 */
final class Battery {

  /** A robot that only stands empties its battery in this time. */
  private static final double STANDS_NS = 8 * 3600e9;

  private static final double FULL_IN_NS = 120e9;

  private final GlobalVarHolder gvh;
  private final double rangeMm;
  private final Persistent<Integer> stored;
  private final GvhCell<Integer> percent;
  private double charge;
  private Point before;
  private long beforeNs;

  /**
   * The robot has a fix.
   *
   * @param rangeMm way on one charge; 0 for a battery that is never empty
   */
  Battery(GlobalVarHolder gvh, double rangeMm) {
    this.gvh = gvh;
    this.rangeMm = rangeMm;
    stored = gvh.plat.persistent("charge", Shapes.INT, 100);
    percent = gvh.variable(FleetFact.CHARGE, stored.get());
    charge = stored.get() / 100.0;
    before = gvh.gps.pose().at();
    beforeNs = gvh.plat.clock.nowNs();
  }

  /** Accounts for way and time since the last call. */
  void tick(boolean isCharging) {
    if (rangeMm == 0) {
      return;
    }
    Point at = gvh.gps.pose().at();
    long nowNs = gvh.plat.clock.nowNs();
    double ns = nowNs - beforeNs;
    double used = isCharging ? -ns / FULL_IN_NS : at.distanceMm(before) / rangeMm + ns / STANDS_NS;
    charge = Math.max(0, Math.min(1, charge - used));
    before = at;
    beforeNs = nowNs;
    int now = (int) Math.floor(100 * charge);
    if (now != percent.variable().get()) {
      percent.set(now);
      stored.set(now);
    }
  }

  /** Whether it suffices for this way, with a reserve of half of it. */
  boolean suffices(double mm) {
    return rangeMm == 0 || charge * rangeMm >= 1.5 * mm;
  }

  boolean isFull() {
    return charge >= 1 - 1e-9;
  }
}
