package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;

/** A painter that works alone and is correct except for one bug. */
public final class FaultyPainter extends LogicThread {

  /** The planted bug. */
  public enum Bug {
    NONE,
    /** Its light stays on while it drives to the next stroke. */
    KEEPS_ITS_LIGHT_ON,
    /** It paints in another colour. */
    TAKES_ANOTHER_INK,
    /** It paints each stroke forwards and backwards. */
    PAINTS_TWICE,
    /** In the middle of each stroke it goes back for 80 mm, with its light on. */
    GOES_BACK,
    /** After each stroke it paints 80 mm from its middle on again. */
    PAINTS_A_PART_AGAIN,
    /** It ends before the last stroke. */
    FORGETS_ONE,
    /** It stops at the end and never reaches DONE. */
    NEVER_ENDS
  }

  private final List<Stroke> strokes;
  private final Bug bug;
  private final GvhCell<Light> light;
  private final GvhCell<Location> location;

  public FaultyPainter(GlobalVarHolder gvh, List<Stroke> strokes, Bug bug) {
    super(gvh);
    this.strokes = strokes;
    this.bug = bug;
    light = gvh.variable(PaintFact.LIGHT, Light.OFF);
    location = gvh.variable(PaintFact.LOCATION, Location.RESUME);
    gvh.plat.moat.setParameters(Painting.motion(gvh.plat.moat.parameters()));
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    int count = bug == Bug.FORGETS_ONE ? strokes.size() - 1 : strokes.size();
    for (Stroke stroke : strokes.subList(0, count)) {
      Polyline path = stroke.path();
      double middleMm = path.lengthMm() / 2;
      drive(path.start());
      Ink ink = bug == Bug.TAKES_ANOTHER_INK ? new Ink(1, 7) : stroke.ink();
      light.set(new Light(stroke.number(), ink));
      if (bug == Bug.GOES_BACK) {
        along(path.between(0, middleMm));
        along(path.between(middleMm - 80, middleMm).reversed());
        along(path.between(middleMm - 80, path.lengthMm()));
      } else {
        along(path);
      }
      if (bug == Bug.PAINTS_TWICE) {
        along(path.reversed());
      } else if (bug == Bug.PAINTS_A_PART_AGAIN) {
        light.set(Light.OFF);
        drive(path.at(middleMm));
        light.set(new Light(stroke.number(), ink));
        along(path.between(middleMm, middleMm + 80));
      }
      if (bug != Bug.KEEPS_ITS_LIGHT_ON) {
        light.set(Light.OFF);
      }
    }
    light.set(Light.OFF);
    await(() -> bug != Bug.NEVER_ENDS);
    location.set(Location.DONE);
    return List.of(count, strokes.size() - count);
  }

  private void along(Polyline path) {
    path.points().forEach(this::drive);
  }

  private void drive(Point to) {
    if (gvh.gps.pose().at().distanceMm(to) > 5) {
      gvh.plat.moat.doMove(new ItemPosition("next", to.xMm(), to.yMm()));
      await(() -> !gvh.plat.moat.inMotion());
    }
  }
}
