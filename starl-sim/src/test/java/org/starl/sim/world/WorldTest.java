package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.Kernel;
import org.starl.trace.TraceEvent;

final class WorldTest {

  private static final double R = 165;
  private static final double EAST = 0;
  private static final double NORTH = StrictMath.PI / 2;
  private static final double WEST = StrictMath.PI;

  private final TestTime time = new TestTime();
  private final TestTrace trace = new TestTrace();
  private World world = worldWith();

  private World worldWith(Obstacle... obstacles) {
    return new World(time, time, trace, WorldLimits.CREATE, Obstacles.of(obstacles));
  }

  private Body bot(int number, double xMm, double yMm, double headingRad) {
    return world.add(new RobotId("bot" + number), new Pose(xMm, yMm, headingRad), R);
  }

  private static WheelCommand straight(double mmPerS) {
    return new WheelCommand(mmPerS, 0);
  }

  @Test
  void aBodyFollowsItsCommandInClosedForm() {
    Body body = bot(0, 100, 200, EAST);
    body.drive(straight(250));
    time.runFor(2);
    assertThat(body.pose()).isEqualTo(new Pose(600, 200, 0));
    body.drive(new WheelCommand(100, StrictMath.PI / 2));
    time.runFor(2);
    // Half a circle of radius 200 / pi to the left.
    assertThat(body.pose().xMm()).isCloseTo(600, within(1e-9));
    assertThat(body.pose().yMm()).isCloseTo(200 + 400 / StrictMath.PI, within(1e-9));
    assertThat(Math.abs(body.pose().headingRad())).isCloseTo(StrictMath.PI, within(1e-9));
  }

  @Test
  void speedsAreLimited() {
    Body body = bot(0, 0, 0, EAST);
    body.drive(straight(9000));
    time.runFor(1);
    assertThat(body.pose().xMm()).isCloseTo(500, within(1e-9));
  }

  @Test
  void aTouchingBodyThatTurnsAlmostNotAtAllIsCheckedSeldom() {
    try (Kernel kernel = new Kernel(CarrierKind.PLATFORM)) {
      World floor =
          new World(kernel, kernel::timer, new TestTrace(), WorldLimits.CREATE, Obstacles.NONE);
      Body pusher = floor.add(new RobotId("bot0"), new Pose(0, 0, EAST), R);
      floor.add(new RobotId("bot1"), new Pose(500, 0, EAST), R);
      pusher.drive(straight(250));
      kernel.run(2_000_000_000L, () -> false);
      assertThat(pusher.isBlocked()).isTrue();
      // A whole turn at this speed takes longer than the longest time in ns.
      pusher.drive(new WheelCommand(250, 1e-15));
      kernel.run(3_000_000_000L, () -> false);
      assertThat(kernel.events()).isLessThan(100);
    }
  }

  @Test
  void collidingBodiesStopWhereTheyTouchAndBothBump() {
    Body left = bot(0, 0, 0, EAST);
    Body right = bot(1, 2000, 0, WEST);
    left.drive(straight(250));
    right.drive(straight(250));
    time.runFor(10);
    double gap = right.pose().xMm() - left.pose().xMm() - 2 * R;
    assertThat(gap).isBetween(0.0, World.TOUCH_MM);
    assertThat(left.isBlocked()).isTrue();
    assertThat(right.isBlocked()).isTrue();
    assertThat(left.bumps()).isEqualTo(Bumps.BOTH);
    assertThat(right.bumps()).isEqualTo(Bumps.BOTH);
    assertThat(left.pose().xMm()).isCloseTo(1000 - R, within(2.0));
  }

  @Test
  void aBumpReportsTheSideOfTheContact() {
    Body body = bot(0, 0, 0, EAST);
    bot(1, 600, 200, EAST);
    body.drive(straight(250));
    time.runFor(5);
    assertThat(body.isBlocked()).isTrue();
    assertThat(body.bumps()).isEqualTo(Bumps.LEFT);
    body.drive(WheelCommand.STOP);
    assertThat(body.bumps()).isEqualTo(Bumps.NONE);
    Body mirrored = bot(2, 0, -2000, EAST);
    bot(3, 600, -2200, EAST);
    mirrored.drive(straight(250));
    time.runFor(5);
    assertThat(mirrored.bumps()).isEqualTo(Bumps.RIGHT);
  }

  @Test
  void aHitBodyReportsBumpsOnItsFrontHalfOnly() {
    Body front = bot(0, 1000, 0, WEST);
    Body back = bot(1, 1000, 1000, EAST);
    Body toFront = bot(2, 0, 0, EAST);
    Body toBack = bot(3, 0, 1000, EAST);
    toFront.drive(straight(250));
    toBack.drive(straight(250));
    time.runFor(5);
    assertThat(front.bumps()).isEqualTo(Bumps.BOTH);
    assertThat(back.bumps()).isEqualTo(Bumps.NONE);
    assertThat(toBack.bumps()).isEqualTo(Bumps.BOTH);
    toFront.drive(straight(-100));
    time.runFor(1);
    assertThat(front.bumps()).isEqualTo(Bumps.NONE);
    assertThat(toFront.pose().xMm()).isCloseTo(1000 - 2 * R - 100, within(2.0));
  }

  @Test
  void aBlockedBodyCanTurnAndDriveAway() {
    world = worldWith(Obstacle.wall(new Point(1000, -5000), new Point(1000, 5000)));
    Body body = bot(0, 0, 0, EAST);
    body.drive(straight(250));
    time.runFor(5);
    assertThat(body.isBlocked()).isTrue();
    assertThat(body.pose().xMm()).isBetween(1000 - R - World.TOUCH_MM, 1000 - R);
    List<Bumps> seen = new ArrayList<>();
    body.onBump(() -> seen.add(body.bumps()));
    // Turns left: the wall wanders from ahead to the right side, then the body runs along it.
    body.drive(new WheelCommand(250, 0.5));
    time.runFor(3);
    assertThat(body.isBlocked()).isTrue();
    assertThat(body.pose().headingRad()).isCloseTo(1.5, within(1e-6));
    assertThat(seen).containsExactly(Bumps.RIGHT);
    time.runFor(0.5);
    assertThat(body.isBlocked()).isFalse();
    assertThat(seen).containsExactly(Bumps.RIGHT, Bumps.NONE);
    assertThat(body.pose().yMm()).isGreaterThan(50);
  }

  @Test
  void aBodyCanDriveAlongAWallItTouches() {
    world = worldWith(Obstacle.wall(new Point(-500, 0), new Point(5000, 0)));
    Body body = bot(0, 0, R + 0.5, EAST);
    body.drive(straight(500));
    time.runFor(8);
    assertThat(body.pose().xMm()).isCloseTo(4000, within(1e-6));
  }

  @Test
  void aFollowerIsFreedWhenTheBodyAheadDrivesOn() {
    Body ahead = bot(0, 500, 0, EAST);
    Body follower = bot(1, 0, 0, EAST);
    follower.drive(straight(200));
    time.runFor(2);
    assertThat(follower.isBlocked()).isTrue();
    ahead.drive(straight(200));
    time.runFor(2);
    assertThat(follower.isBlocked()).isFalse();
    assertThat(follower.pose().xMm()).isCloseTo(500 - 2 * R + 400, within(5.0));
  }

  @Test
  void aBodyIsFreedWhenItsObstacleDisappears() {
    Body inTheWay = bot(0, 500, 0, EAST);
    Body body = bot(1, 0, 0, EAST);
    body.drive(straight(200));
    time.runFor(2);
    world.remove(inTheWay);
    time.runFor(5);
    assertThat(body.isBlocked()).isFalse();
    assertThat(body.bumps()).isEqualTo(Bumps.NONE);
    assertThat(body.pose().xMm()).isGreaterThan(1000);
    assertThatThrownBy(() -> inTheWay.drive(straight(1))).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void aWallExistsForItsLifetime() {
    List<Point> ends = List.of(new Point(1000, -500), new Point(1000, 500));
    world = worldWith(new Obstacle(ends, false, false, 10_000));
    Body body = bot(0, 0, 0, EAST);
    body.drive(straight(200));
    time.runUntil(10_000_000_000L);
    assertThat(body.pose().xMm()).isLessThan(1000 - R);
    time.runFor(5);
    assertThat(body.pose().xMm()).isCloseTo(1000 - R + 1000, within(2.0));
  }

  @Test
  void theErrorForAnOccupiedPlaceNamesTheRobot() {
    world = worldWith(Obstacle.body(point(0, 0), point(4000, 0), point(4000, 4000)));
    bot(0, -1000, 0, EAST);
    assertThatThrownBy(() -> bot(1, -1000 + 2 * R - 1, 0, EAST))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("bot1")
        .hasMessageContaining("would overlap bot0");
    assertThatThrownBy(() -> bot(1, 3000, 1000, EAST)).hasMessageContaining("a solid obstacle");
    assertThatThrownBy(() -> bot(1, 2000, -100, EAST)).hasMessageContaining("a wall");
    assertThat(world.isFree(new Pose(-1000 + 2 * R, 0, 0), R)).isTrue();
    assertThat(world.bodies()).hasSize(1);
  }

  @Test
  void withoutCollisionsBodiesPassThroughEverything() {
    world =
        new World(
            time,
            time,
            trace,
            new WorldLimits(500, 4, false, false),
            Obstacles.of(Obstacle.wall(point(500, -500), point(500, 500))));
    Body body = bot(0, 0, 0, EAST);
    bot(1, 1000, 0, NORTH);
    body.drive(straight(500));
    time.runFor(4);
    assertThat(body.pose().xMm()).isCloseTo(2000, within(1e-9));
    assertThat(body.bumps()).isEqualTo(Bumps.NONE);
  }

  @Test
  void aBodyWithErrorsTurnsAwayFromWhatItsWheelsPushItAgainst() {
    WorldLimits rolling = new WorldLimits(500, 4, true, true);
    Obstacle wall = Obstacle.wall(point(500, -5000), point(500, 5000));
    world = new World(time, time, trace, rolling, Obstacles.of(wall));
    Body body = bot(0, 0, 0, 0.5);
    body.drive(straight(100));
    time.runFor(4);
    assertThat(body.bumps()).as("the wall is on its right").isEqualTo(Bumps.RIGHT);
    double pushesRad = body.pose().headingRad();
    time.runFor(0.1);
    assertThat(body.pose().headingRad() - pushesRad).isCloseTo(0.1, within(1e-6));
    time.runFor(5);
    assertThat(body.pose().headingRad()).as("the wall is beside it").isBetween(1.3, NORTH);
  }

  @Test
  void eachChangeOfTrueMotionIsTraced() {
    Body body = bot(0, 0, 0, EAST);
    bot(1, 1000, 0, EAST);
    body.drive(straight(250));
    body.drive(straight(250));
    time.runFor(5);
    body.drive(straight(-250));
    List<TraceEvent.Moved> moves = trace.of(TraceEvent.Moved.class);
    assertThat(moves)
        .extracting(TraceEvent.Moved::linearMmPerS)
        .containsExactly(250.0, 0.0, -250.0);
    assertThat(moves.get(1).timeNs()).isCloseTo(2_680_000_000L, within(4_000_000L));
    assertThat(moves.get(1).pose()).isEqualTo(moves.get(2).pose());
    assertThat(trace.of(TraceEvent.Joined.class)).hasSize(2);
  }

  @Test
  void bodiesAtRestScheduleNoEvents() {
    for (int i = 0; i < 100; i++) {
      bot(i, 1000 * i, 0, EAST);
    }
    time.runFor(1);
    long before = time.events();
    time.runFor(1000);
    assertThat(time.events()).isEqualTo(before);
  }

  @Test
  void bodiesWithinARangeAreFound() {
    Body near = bot(0, 0, 0, EAST);
    bot(1, 3001, 0, EAST);
    Body driving = bot(2, 4000, 0, WEST);
    driving.drive(straight(250));
    bot(3, 8000, 0, EAST);
    time.runFor(1);
    List<Body> found = new ArrayList<>();
    world.forEachWithin(point(750, 0), 3000, found::add);
    assertThat(found).contains(near, driving).hasSize(3);
  }

  private static Point point(double xMm, double yMm) {
    return new Point(xMm, yMm);
  }
}
