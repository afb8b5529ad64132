package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Rectangle;
import org.starl.gvh.GvhCell;
import org.starl.motion.MotionFlag;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.shape.Shapes;
import org.starl.trace.Var;

/**
 * One robot patrols on a ring of waypoints. The rings of all robots share the corridor, in which
 * only one robot may be at a time.
 */
final class PatrolApp extends LogicThread {

  /** The corridor, across the whole floor. */
  static final Rectangle CORRIDOR = new Rectangle(0, 1200, 5000, 1800);

  static final String CORRIDOR_NAME = "corridor";

  static final Var<Integer> ROUNDS = Var.of("rounds", Shapes.INT);
  static final Var<String> WAY = Var.of("way", Shapes.TEXT);

  /** A ring: its home, then the waypoints in the order of the patrol. */
  record Ring(
      ItemPosition home,
      ItemPosition before,
      ItemPosition in,
      ItemPosition out,
      ItemPosition behind) {

    /** Rings 0 and 2 are above the corridor, 1 and 3 below; 0 and 1 lie inside 2 and 3. */
    static Ring of(int robot) {
      double middleY = 1500;
      double halfWidth = robot < 2 ? 700 : 1500;
      double homeY = middleY + (robot % 2 == 0 ? 1 : -1) * (robot < 2 ? 700 : 1300);
      double left = 2500 - halfWidth;
      double right = 2500 + halfWidth;
      return new Ring(
          new ItemPosition("home", 2500, homeY),
          new ItemPosition("before", left, homeY),
          new ItemPosition("in", left, middleY),
          new ItemPosition("out", right, middleY),
          new ItemPosition("behind", right, homeY));
    }
  }

  private final MutexPrim mutex;
  private final GvhCell<Integer> made;
  private final GvhCell<String> way;
  private final Ring ring;
  private final int rounds;

  PatrolApp(GlobalVarHolder gvh, Ring ring, int rounds) {
    super(gvh);
    this.ring = ring;
    this.rounds = rounds;
    mutex = new M_Mutex(gvh, CORRIDOR_NAME, gvh.id.participants());
    made = gvh.variable(ROUNDS, 0);
    way = gvh.variable(WAY, "home");
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    while (made.get() < rounds) {
      driveTo(ring.before());
      enterCorridor();
      driveTo(ring.in());
      driveTo(ring.out());
      driveTo(ring.behind());
      mutex.release(CORRIDOR_NAME);
      driveTo(ring.home());
      made.set(made.get() + 1);
    }
    return List.of("rounds: " + made.get());
  }

  /** Waits for the corridor. A request that failed is made again after a moment. */
  private void enterCorridor() {
    requestCorridor();
    while (!mutex.crit().get()) {
      sleep(500);
      requestCorridor();
    }
  }

  private void requestCorridor() {
    mutex.do_mutex(List.of(CORRIDOR_NAME));
    await("the corridor is free", () -> mutex.crit().get() || mutex.failed().get());
  }

  /** Drives until the robot is there; a drive that failed begins again after a moment. */
  private void driveTo(ItemPosition place) {
    way.set(place.name());
    gvh.plat.moat.doMove(place);
    await("at " + place.name(), () -> !gvh.plat.moat.inMotion());
    while (gvh.plat.moat.motionflag().get() != MotionFlag.DONE) {
      sleep(500);
      gvh.plat.moat.doMove(place);
      await("at " + place.name(), () -> !gvh.plat.moat.inMotion());
    }
  }
}
