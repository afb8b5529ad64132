package org.starl.apps.lightpaint.logic;

import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.TubeFlag;

/**
 * Moves a painter in tubes: to its work and back to its home with the light off, along a stroke with
 * the light on. Strand only.
 */
final class PainterMotion {

  private static final double HOME_MM = 100;
  private static final double ARRIVED_MM = 12;

  private final GlobalVarHolder gvh;
  private final DistributedPathPlanning paths;
  private final ItemPosition home;
  private final GvhCell<Light> light;

  PainterMotion(GlobalVarHolder gvh, DistributedPathPlanning paths, Point home) {
    this.gvh = gvh;
    this.paths = paths;
    this.home = new ItemPosition("home", home.xMm(), home.yMm());
    light = gvh.variable(PaintTrace.SOURCE, PaintTrace.LIGHT, Light.OFF);
  }

  /** Sets out to where {@code work} continues. */
  void goTo(CurrentWork work) {
    Point next = work.next();
    paths.goTo(new ItemPosition("stroke" + work.number(), next.xMm(), next.yMm()));
  }

  /** Whether the painter has arrived where {@code work} continues, and {@link #mayPaint}. */
  boolean isAt(CurrentWork work) {
    boolean isNear = gvh.gps.pose().at().distanceMm(work.next()) <= ARRIVED_MM;
    boolean hasArrived = paths.tubeflag().get() == TubeFlag.DONE || isNear;
    return !paths.isUnderWay() && hasArrived && mayPaint(work);
  }

  /** Whether the painter is certainly near enough for {@link #paint}. */
  boolean mayPaint(CurrentWork work) {
    double offMm = Painting.TUBES.positionErrorMm() + gvh.plat.moat.parameters().goalRadiusMm();
    return gvh.gps.maxDistanceMm(work.next()) <= offMm;
  }

  /** Starts to paint the rest of {@code work}; the painter stands where it continues. */
  void paint(CurrentWork work) {
    paths.goAlong(new Path(work.rest().points()));
  }

  /**
   * Switches the light, on exactly while the painter moves in its tube, and records progress. To be
   * called whenever the tube's flag changes and periodically, until the tube's end.
   */
  void shine(CurrentWork work) {
    if (paths.tubeflag().get() == TubeFlag.MOVING) {
      light.set(Light.of(work.stroke()));
    }
    if (light.get().isOn()) {
      work.paintedTo(gvh.gps.pose().at());
    }
    if (!paths.isUnderWay()) {
      light.set(Light.OFF);
    }
  }

  /** Whether the painter is at home and holds only its place there; if not, it goes there. */
  boolean goHome() {
    if (paths.isUnderWay()) {
      return false;
    }
    boolean isHome = gvh.gps.minDistanceMm(home.at()) <= HOME_MM;
    // A painter that was stopped on its way still holds the rest of its tube.
    if (isHome && paths.held().stream().allMatch(tube -> tube.points().size() == 1)) {
      return true;
    }
    // After an arrival the tube is given back once storage has flushed that. Setting out again
    // before would claim another tube, for ever if storage is slow.
    boolean isGivingBack = isHome && paths.tubeflag().get() == TubeFlag.DONE;
    if (!isGivingBack) {
      paths.goTo(home);
    }
    return false;
  }
}
