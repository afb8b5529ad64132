package org.starl.apps.lightpaint.logic;

import org.starl.GlobalVarHolder;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;

/**
 * Paints what a painter has in hand: takes it along the stroke in a tube, with its light on exactly
 * while it moves there. Strand only.
 */
final class Brush {

  /** How it stands with the latest stroke. */
  enum State {
    UNDER_WAY,
    PAINTED,
    /** Stands on the stroke: stuck wheels, no fix. */
    HELD_UP,
    NO_TUBE
  }

  private final GlobalVarHolder gvh;
  private final DistributedPathPlanning paths;
  private final GvhCell<Light> light;

  Brush(GlobalVarHolder gvh, DistributedPathPlanning paths) {
    this.gvh = gvh;
    this.paths = paths;
    light = gvh.variable(PaintTrace.SOURCE, PaintTrace.LIGHT, Light.OFF);
  }

  /** Begins, standing where {@code work} goes on. */
  void along(Work work) {
    paths.goAlong(new Path(work.rest().points()));
  }

  /** To be asked until it is not under way, whenever the tube's flag changes: keeps the light. */
  State look(InHand inHand) {
    if (paths.tubeflag().get() == TubeFlag.MOVING) {
      light.set(Light.of(inHand.stroke()));
    }
    if (light.get().isOn()) {
      inHand.painted(gvh.gps.pose().at());
    }
    if (paths.isUnderWay()) {
      return State.UNDER_WAY;
    }
    light.set(Light.OFF);
    if (paths.failed()) {
      return paths.failure().get() == TubeFailure.MOTION ? State.HELD_UP : State.NO_TUBE;
    }
    inHand.finish();
    return State.PAINTED;
  }
}
