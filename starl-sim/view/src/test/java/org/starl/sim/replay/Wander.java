package org.starl.sim.replay;

import java.time.Duration;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Drives to random places, or to points that the user sends. */
final class Wander extends LogicThread {

  private static final int ROUNDS = 12;

  private int xMm;
  private int yMm;
  private boolean hasPoint;

  Wander(GlobalVarHolder gvh) {
    super(gvh);
  }

  /** Three robots for 30 s. */
  static Simulation.Builder simulation(long seed) {
    SimSettings settings = SimSettings.builder().duration(Duration.ofSeconds(30)).build();
    return Simulation.builder().name("wander").settings(settings).seed(seed).robots(3, Wander::new);
  }

  @Override
  public List<Object> callStarL() {
    Rng rng = gvh.plat.entropy.fork("places");
    await(gvh.gps::hasFix);
    for (int i = 0; i < ROUNDS; i++) {
      if (!hasPoint) {
        xMm = rng.nextInt(4000);
        yMm = rng.nextInt(4000);
      }
      hasPoint = false;
      gvh.log.i("wander", "to " + xMm + "," + yMm);
      gvh.plat.moat.doMove(new ItemPosition("place" + i, xMm, yMm));
      while (gvh.plat.moat.inMotion() && !hasPoint) {
        sleep(100);
      }
    }
    return List.of(gvh.gps.pose());
  }

  @Override
  public void receivedPointInput(int newXMm, int newYMm) {
    xMm = newXMm;
    yMm = newYMm;
    hasPoint = true;
  }
}
