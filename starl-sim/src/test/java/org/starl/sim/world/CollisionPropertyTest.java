package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.starl.body.WheelCommand;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/** Random bodies under random commands, watched in fine steps. */
final class CollisionPropertyTest {

  private static final double SIDE_MM = 3000;
  private static final long STEP_NS = 5_000_000;

  private final TestTime time = new TestTime();
  private final List<Body> bodies = new ArrayList<>();

  @Property(tries = 20)
  void bodiesNeverOverlapAndNeverPassWalls(
      @ForAll long seed, @ForAll @IntRange(min = 2, max = 14) int count) {
    Rng rng = new Rng(seed);
    World world = room(rng);
    fill(world, rng, count);
    int contacts = 0;
    for (int step = 0; step < 40_000_000_000L / STEP_NS; step++) {
      for (Body body : bodies) {
        if (rng.nextInt(100) == 0) {
          body.drive(command(rng));
        }
      }
      time.runFor(STEP_NS / 1e9);
      contacts += checkNoOverlap(world);
    }
    assertThat(contacts).as("a run in which nothing touched tests nothing").isPositive();
  }

  @Property(tries = 20)
  void freeBodiesFollowTheirCommands(@ForAll long seed) {
    Rng rng = new Rng(seed);
    World world = new World(time, time, new TestTrace(), WorldLimits.CREATE, Obstacles.NONE);
    bodies.clear();
    List<Pose> expected = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      Pose start = new Pose(20_000 * i, 0, i);
      bodies.add(world.add(new RobotId("bot" + i), start, 165));
      expected.add(start);
    }
    for (int leg = 0; leg < 20; leg++) {
      double seconds = rng.nextDouble();
      for (int i = 0; i < bodies.size(); i++) {
        WheelCommand command = command(rng);
        bodies.get(i).drive(command);
        expected.set(i, bruteForce(expected.get(i), command, seconds));
      }
      time.runFor(seconds);
    }
    for (int i = 0; i < bodies.size(); i++) {
      assertThat(bodies.get(i).pose().distanceMm(expected.get(i).at())).isLessThan(1);
    }
  }

  /** Many small straight steps. */
  private static Pose bruteForce(Pose start, WheelCommand command, double seconds) {
    double x = start.xMm();
    double y = start.yMm();
    double heading = start.headingRad();
    int steps = 2000;
    double dt = seconds / steps;
    for (int i = 0; i < steps; i++) {
      double middle = heading + command.angularRadPerS() * dt / 2;
      x += command.linearMmPerS() * dt * StrictMath.cos(middle);
      y += command.linearMmPerS() * dt * StrictMath.sin(middle);
      heading += command.angularRadPerS() * dt;
    }
    return new Pose(x, y, heading);
  }

  private World room(Rng rng) {
    List<Obstacle> obstacles = new ArrayList<>();
    obstacles.add(
        Obstacle.wall(
            new Point(0, 0),
            new Point(SIDE_MM, 0),
            new Point(SIDE_MM, SIDE_MM),
            new Point(0, SIDE_MM),
            new Point(0, 0)));
    for (int i = 0; i < 3; i++) {
      Point at = new Point(400 + 2000 * rng.nextDouble(), 400 + 2000 * rng.nextDouble());
      obstacles.add(Obstacle.body(at, at.plus(new Point(200, 50)), at.plus(new Point(80, 250))));
    }
    return new World(time, time, new TestTrace(), WorldLimits.CREATE, new Obstacles(obstacles));
  }

  private void fill(World world, Rng rng, int count) {
    bodies.clear();
    for (int i = 0; i < count * 20 && bodies.size() < count; i++) {
      double radiusMm = 100 + 80 * rng.nextDouble();
      Pose pose =
          new Pose(SIDE_MM * rng.nextDouble(), SIDE_MM * rng.nextDouble(), 6.28 * rng.nextDouble());
      boolean inside =
          Math.min(pose.xMm(), pose.yMm()) > 0 && Math.max(pose.xMm(), pose.yMm()) < SIDE_MM;
      if (inside && world.isFree(pose, radiusMm)) {
        bodies.add(world.add(new RobotId("bot" + i), pose, radiusMm));
      }
    }
  }

  private static WheelCommand command(Rng rng) {
    double turn = rng.nextInt(3) == 0 ? 0 : 6 * rng.nextDouble() - 3;
    double mmPerS = rng.nextInt(5) == 0 ? 0 : 1000 * rng.nextDouble() - 400;
    return new WheelCommand(Math.max(-500, Math.min(500, mmPerS)), turn);
  }

  private int checkNoOverlap(World world) {
    int contacts = 0;
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      Pose pose = body.pose();
      for (int j = 0; j < i; j++) {
        Body other = bodies.get(j);
        double gap = pose.distanceMm(other.pose().at()) - body.radiusMm() - other.radiusMm();
        assertThat(gap).as("%s and %s", body, other).isGreaterThanOrEqualTo(0);
        contacts += gap < World.TOUCH_MM ? 1 : 0;
      }
      double wallGap = world.obstacles().distanceMm(pose.at()) - body.radiusMm();
      assertThat(wallGap).as("%s and a wall", body).isGreaterThanOrEqualTo(0);
      assertThat(pose.xMm()).isBetween(0.0, SIDE_MM);
      assertThat(pose.yMm()).isBetween(0.0, SIDE_MM);
      contacts += wallGap < World.TOUCH_MM ? 1 : 0;
    }
    return contacts;
  }
}
