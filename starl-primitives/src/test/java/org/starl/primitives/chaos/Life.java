package org.starl.primitives.chaos;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.starl.random.Rng;

/**
 * A world's life, drawn from its seed: robots act, crash and restart, the network is foul and cut;
 * then all heals, and progress is owed.
 */
public final class Life<R extends LiveRobot> {

  private static final long FOUL_MS = 20_000;

  private final LiveWorld<R> world;
  private final Rng rng;
  private final Consumer<R> act;
  private boolean foul = true;

  /** Which part of the robots ever crashes, from 0 to 1. */
  public double crashChance = 1;

  /** Whether crashed robots restart. */
  public boolean restarts = true;

  /**
   * @param act what a robot that is up does from time to time, if there is anything to do for it
   */
  public Life(LiveWorld<R> world, Rng rng, Consumer<R> act) {
    this.world = world;
    this.rng = rng;
    this.act = act;
  }

  /** Lives through foul times, then through fair ones; returns whether {@code well} came about. */
  public boolean live(BooleanSupplier well, long withinMs) {
    world.weather(rng.nextBoolean(0.3) ? Weather.LOSSY : Weather.FOUL);
    world.robots.forEach(LiveRobot::start);
    world.robots.forEach(this::keepActing);
    for (R robot : world.robots) {
      if (rng.nextBoolean(crashChance)) {
        nextCrash(robot);
      }
    }
    nextCut();
    world.runForMs(FOUL_MS);
    foul = false;
    world.weather(Weather.FAIR);
    world.cutAt(0);
    if (restarts) {
      world.robots.stream().filter(robot -> !robot.isUp()).forEach(LiveRobot::start);
    }
    return world.runUntil(well, withinMs);
  }

  private void keepActing(R robot) {
    if (robot.isUp()) {
      act.accept(robot);
    }
    world.afterMs(rng.nextLong(20, foul ? 2_000 : 100), () -> keepActing(robot));
  }

  private void nextCrash(R robot) {
    world.afterMs(
        rng.nextLong(500, 15_000),
        () -> {
          boolean mayCrash =
              restarts || world.robots.stream().filter(LiveRobot::isUp).count() > majority();
          if (foul && robot.isUp() && mayCrash) {
            robot.crash();
            if (restarts) {
              world.afterMs(rng.nextLong(0, 3_000), () -> restart(robot));
            }
          }
        });
  }

  /** Of crashes for good, a majority of the robots is spared. */
  private long majority() {
    return world.robots.size() / 2 + 1;
  }

  private void restart(R robot) {
    if (foul) {
      robot.start();
      nextCrash(robot);
    }
  }

  private void nextCut() {
    world.afterMs(
        rng.nextLong(500, 5_000),
        () -> {
          if (foul) {
            world.cutAt(rng.nextInt(world.robots.size()));
            nextCut();
          }
        });
  }
}
