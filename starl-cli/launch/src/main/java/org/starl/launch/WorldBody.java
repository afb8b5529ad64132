package org.starl.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.platform.Strand;
import org.starl.robot.create.CreateBody;
import org.starl.robot.create.CreateTravel;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.optitrack.PoseSource;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;
import org.starl.time.Time;

/**
 * A body in the {@link WorldServer}, moved by a simulated Create or a program and seen by the
 * cameras. It belongs to the world's strand; Creates and programs use it from their own threads.
 */
final class WorldBody extends SimulatedBody implements CreateBody {

  private final String rigidBody;
  private final double axleMm;
  private final Strand strand;
  private final SimChassis chassis;

  // Written on the world's strand, read by Creates and programs.
  private volatile Bumps bumps = Bumps.NONE;
  private volatile Senses near = Senses.NOTHING;
  private volatile boolean isUp = true;

  // Set by the program's thread, called on the world's strand.
  private volatile Runnable onBump = () -> {};
  private volatile Wheelbase.@Nullable TravelReceiver odometer;

  // The world's strand only.
  private Pose lastPose;
  private CreateTravel travel = CreateTravel.NONE;
  private long travelledNs;

  WorldBody(
      RobotSpec spec,
      String rigidBody,
      SimSettings settings,
      double axleMm,
      World world,
      Strand strand,
      SimChassis chassis) {
    super(spec, settings, world, chassis);
    this.rigidBody = rigidBody;
    this.axleMm = axleMm;
    this.strand = strand;
    this.chassis = chassis;
    lastPose = spec.start();
    chassis.onBump(() -> {
      bumps = chassis.bumps();
      onBump.run();
    });
  }

  @Override
  public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
    WheelCommand command =
        new WheelCommand((leftMmPerS + rightMmPerS) / 2, (rightMmPerS - leftMmPerS) / axleMm);
    drive(() -> command);
  }

  /** The same, from any thread; {@code command} is evaluated on the world's strand. */
  void drive(Supplier<WheelCommand> command) {
    strand.post(() -> chassis.drive(command.get()));
  }

  /** The contacts now. From any thread. */
  Bumps bumps() {
    return bumps;
  }

  /** {@code receiver} is called on the world's strand when {@link #bumps} has changed. */
  void onBump(Runnable receiver) {
    onBump = receiver;
  }

  /** {@code receiver} is called on the world's strand, with a way that does not slip. */
  void onTravel(Wheelbase.TravelReceiver receiver) {
    receiver.lifted(isUp);
    odometer = receiver;
  }

  private void travel(Pose from, Pose to, long nowNs) {
    double turn = Angles.difference(to.headingRad(), from.headingRad());
    double middleRad = from.headingRad() + turn / 2;
    double wayMm =
        StrictMath.cos(middleRad) * (to.xMm() - from.xMm())
            + StrictMath.sin(middleRad) * (to.yMm() - from.yMm());
    travel = new CreateTravel(travel.forwardMm() + wayMm, travel.turnedRad() + turn);
    Wheelbase.TravelReceiver receiver = odometer;
    if (receiver != null && nowNs > travelledNs) {
      receiver.lifted(false);
      double mmPerS =
          (Math.abs(wayMm) + Math.abs(turn) * axleMm / 2) / Time.seconds(nowNs - travelledNs);
      receiver.travelled(nowNs, travel, mmPerS, bumps.any());
    }
    travelledNs = nowNs;
  }

  @Override
  public Senses senses(long atNs) {
    if (isUp) {
      return Senses.lifted();
    }
    Bumps now = bumps;
    return Senses.bumps(
            now == Bumps.LEFT || now == Bumps.BOTH, now == Bumps.RIGHT || now == Bumps.BOTH)
        .and(near);
  }

  @Override
  void lift() {
    if (isOnFloor()) {
      lastPose = onFloor().pose();
    }
    super.lift();
    isUp = true;
    Wheelbase.TravelReceiver to = odometer;
    if (to != null) {
      to.lifted(true);
    }
    bumps = Bumps.NONE;
    near = Senses.NOTHING;
  }

  /** Which sensors of the light bumper see a wall or another body. */
  private Senses near(Pose at) {
    List<Sense> seen = new ArrayList<>();
    double probeMm = Wheelbase.NEAR_MM / 2 - 1;
    for (int i = 0; i < LIGHT_BUMPER.size(); i++) {
      double headingRad = at.headingRad() + StrictMath.PI * (5 - 2 * i) / 12;
      double reachMm = radiusMm() + Wheelbase.NEAR_MM / 2;
      Point middle =
          at.at()
              .plus(
                  new Point(
                      reachMm * StrictMath.cos(headingRad), reachMm * StrictMath.sin(headingRad)));
      if (!isFree(Pose.of(middle, 0), probeMm)) {
        seen.add(LIGHT_BUMPER.get(i));
        if (i == LIGHT_BUMPER.size() - 1) {
          seen.add(Sense.WALL);
        }
      }
    }
    return Senses.of(seen.toArray(new Sense[0]));
  }

  /** The body as cameras see it: tracked only on the floor. */
  PoseSource.Body seen(long nowNs) {
    isUp = !isOnFloor();
    if (isOnFloor()) {
      Pose before = lastPose;
      lastPose = onFloor().pose();
      travel(before, lastPose, nowNs);
      near = near(lastPose);
    }
    return new PoseSource.Body(rigidBody, lastPose, isOnFloor(), 0);
  }
}
