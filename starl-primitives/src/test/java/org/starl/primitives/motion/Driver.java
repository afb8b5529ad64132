package org.starl.primitives.motion;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.motion.MotionFlag;
import org.starl.random.Rng;

/** Drives to random targets around random regions, in order; returns the flags. */
final class Driver extends LogicThread {

  private static final int DRIVES = 8;

  private final Rng rng;
  private final MotionPrim mc;

  Driver(GlobalVarHolder gvh) {
    super(gvh);
    rng = gvh.plat.entropy.fork("driver");
    mc = new MotionControl(gvh);
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    List<Object> flags = new ArrayList<>();
    for (int i = 0; i < DRIVES; i++) {
      if (rng.nextBoolean(0.2)) {
        mc.gotopoint(target());
      } else {
        mc.do_move(target(), region());
      }
      // Sometimes a new command replaces the motion.
      long patienceMs = rng.nextBoolean(0.2) ? rng.nextLong(0, 4_000) : 400_000;
      await(() -> mc.motionflag().get() != MotionFlag.MOVING, patienceMs);
      flags.add(mc.motionflag().get());
    }
    mc.close();
    return flags;
  }

  private ItemPosition target() {
    Point at = point();
    return new ItemPosition("goal", at.xMm(), at.yMm());
  }

  private Point point() {
    return new Point(300 + 4400 * rng.nextDouble(), 300 + 2400 * rng.nextDouble());
  }

  private Region region() {
    Point at = point();
    double size = 50 + 600 * rng.nextDouble();
    return switch (rng.nextInt(5)) {
      case 0 -> new Nowhere();
      case 1 -> new Circle(at, size);
      case 2 -> Rectangle.around(at, size, 2 * size);
      case 3 -> Union.of(new Circle(at, size), Rectangle.around(point(), size, size));
      default ->
          Polygon.of(
              at,
              at.plus(new Point(size, size / 8)),
              at.plus(new Point(size / 3, size / 3)),
              at.plus(new Point(size / 8, size)));
    };
  }
}
