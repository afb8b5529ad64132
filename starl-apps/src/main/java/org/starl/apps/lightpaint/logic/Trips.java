package org.starl.apps.lightpaint.logic;

import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeFlag;

/**
 * Where a painter goes with its light off: to where its work goes on, and back to its own place
 * beside the drawing. Strand only.
 */
final class Trips {

  private static final double HOME_MM = 100;
  private static final double AT_MM = 12;

  private final GlobalVarHolder gvh;
  private final DistributedPathPlanning paths;
  private final ItemPosition home;

  Trips(GlobalVarHolder gvh, DistributedPathPlanning paths, Point home) {
    this.gvh = gvh;
    this.paths = paths;
    this.home = new ItemPosition("home", home.xMm(), home.yMm());
  }

  /** Sets out to where {@code work} goes on. */
  void to(Work work) {
    String name = "stroke" + work.stroke().number();
    paths.goTo(new ItemPosition(name, work.next().xMm(), work.next().yMm()));
  }

  /** Whether it has come to where {@code work} goes on, and may begin. */
  boolean isThere(Work work) {
    boolean isAt = gvh.gps.pose().at().distanceMm(work.next()) <= AT_MM;
    boolean hasCome = paths.tubeflag().get() == TubeFlag.DONE || isAt;
    return !paths.isUnderWay() && hasCome && mayBegin(work);
  }

  /** Whether it stands there as near as a way along the work needs, for certain. */
  boolean mayBegin(Work work) {
    double offMm = Painting.TUBES.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm();
    return gvh.gps.farthestMm(work.next()) <= offMm;
  }

  /** Whether it stands in its own place and holds no more than that; if not, it goes there. */
  boolean isBack() {
    if (paths.isUnderWay()) {
      return false;
    }
    boolean isThere = gvh.gps.nearestMm(home.at()) <= HOME_MM;
    if (isThere && holdsNoWay()) {
      return true;
    }
    // Who has arrived gives its way back as soon as its storage has that: to set out again at once
    // would be to claim another one, for ever where storage is slow.
    boolean givesBack = isThere && paths.tubeflag().get() == TubeFlag.DONE;
    if (!givesBack) {
      paths.goTo(home);
    }
    return false;
  }

  /** Who was stopped on its way goes on holding it. */
  private boolean holdsNoWay() {
    return paths.held().stream().allMatch(tube -> tube.points().size() == 1);
  }
}
