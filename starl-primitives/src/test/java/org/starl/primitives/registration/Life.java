package org.starl.primitives.registration;

import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.chaos.Weather;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;

/**
 * A random run of a town, from its seed: robots register and unregister, crash and restart, and suspect
 * each other, rightly or wrongly, over a faulty and partitioned network. Then all heals: every robot must
 * reach its goal, and the list must hold exactly the robots that want to be registered.
 */
final class Life {

  static final long BOUND_MS = 60_000;
  private static final long FOUL_MS = 20_000;
  private static final int MAX_ROBOTS = 6;

  final Town town;
  private final Rng rng;
  private boolean foul = true;

  /** Whether, after healing, every robot reached its goal within the bound. */
  boolean gotWell;

  Life(long seed) {
    Rng draws = new Rng(seed).fork("life");
    int size = 2 + draws.nextInt(MAX_ROBOTS - 1);
    int acceptors = 1 + draws.nextInt(size);
    rng = draws;
    town = new Town(seed, size, acceptors, new RegistrationSpec());
    town.weather = draws.nextBoolean(0.3) ? Weather.LOSSY : Weather.FOUL;
    town.settings = RegistrationSettings.DEFAULT.withDeadlineMs(draws.nextLong(1_000, 10_000));
  }

  /** Lives; returns what the specification found. */
  SpecReport live() {
    town.startAll();
    town.robots.values().forEach(this::nextWish);
    town.robots.values().forEach(this::nextCrash);
    town.robots.values().forEach(this::nextSuspicion);
    nextCut();
    town.runForMs(FOUL_MS);
    heal();
    return town.finish();
  }

  private boolean getsWell() {
    return town.runUntil(
        () -> town.robots.values().stream().allMatch(TownRobot::isSatisfied) && isTidy(), BOUND_MS);
  }

  /** Whether the latest known list has only robots that want to be registered. */
  private boolean isTidy() {
    View latest = View.NONE;
    SortedSet<ProcessId> members = new TreeSet<>();
    for (TownRobot robot : town.robots.values()) {
      View view = robot.protocol().view();
      latest = view.number() > latest.number() ? view : latest;
      if (robot.wantsIn) {
        members.add(robot.protocol().me());
      }
    }
    return latest.mentioned().equals(members);
  }

  private void heal() {
    foul = false;
    town.weather = Weather.FAIR;
    town.cutAt = 0;
    for (TownRobot robot : town.robots.values()) {
      if (!robot.isUp()) {
        robot.start();
      }
      keepPursuing(robot);
    }
    gotWell = getsWell();
  }

  private void keepPursuing(TownRobot robot) {
    robot.pursue();
    robot.tidy();
    town.afterMs(100, () -> keepPursuing(robot));
  }

  private void nextWish(TownRobot robot) {
    if (foul) {
      robot.pursue();
      town.afterMs(
          rng.nextLong(50, 3_000),
          () -> {
            if (foul) {
              robot.wantsIn = rng.nextBoolean(0.6);
              nextWish(robot);
            }
          });
    }
  }

  private void nextCrash(TownRobot robot) {
    town.afterMs(
        rng.nextLong(500, 15_000),
        () -> {
          if (foul && robot.isUp()) {
            robot.crash();
            town.afterMs(rng.nextLong(0, 3_000), () -> restart(robot));
          }
        });
  }

  private void nextSuspicion(TownRobot robot) {
    town.afterMs(
        rng.nextLong(1_000, 15_000),
        () -> {
          if (foul) {
            robot.confine(rng);
            nextSuspicion(robot);
          }
        });
  }

  private void restart(TownRobot robot) {
    if (foul) {
      robot.start();
      nextCrash(robot);
    }
  }

  private void nextCut() {
    town.afterMs(
        rng.nextLong(500, 5_000),
        () -> {
          if (foul) {
            town.cutAt = rng.nextInt(town.robots.size());
            nextCut();
          }
        });
  }
}
