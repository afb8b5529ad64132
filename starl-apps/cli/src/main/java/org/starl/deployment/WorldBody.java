package org.starl.deployment;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Strand;
import org.starl.robot.create.CreateBody;
import org.starl.robot.optitrack.PoseSource;
import org.starl.sim.world.Body;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;

/**
 * One robot's body in the world of a deployment: what a simulated Create moves and feels with, and what
 * cameras see of it. The world's strand has it; the Create and the cameras ask from theirs.
 */
final class WorldBody implements CreateBody {

  private final RobotId id;
  private final String rigidBody;
  private final Pose start;
  private final double radiusMm;
  private final double axleMm;
  private final World world;
  private final Strand strand;
  private final SimChassis chassis;

  // The world's strand writes it; Creates and programs read it on threads of theirs.
  private volatile Bumps bumps = Bumps.NONE;

  // Set by the program's thread, called on the world's strand.
  private volatile Runnable bumped = () -> {};

  // The world's strand only.
  private @Nullable Body body;
  private Pose lastPose;

  WorldBody(
      RobotId id,
      String rigidBody,
      Pose start,
      double radiusMm,
      double axleMm,
      World world,
      Strand strand,
      SimChassis chassis) {
    this.id = id;
    this.rigidBody = rigidBody;
    this.start = start;
    this.radiusMm = radiusMm;
    this.axleMm = axleMm;
    this.world = world;
    this.strand = strand;
    this.chassis = chassis;
    lastPose = start;
    chassis.onBump(() -> {
      bumps = chassis.bumps();
      bumped.run();
    });
  }

  @Override
  public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
    WheelCommand command =
        new WheelCommand((leftMmPerS + rightMmPerS) / 2, (rightMmPerS - leftMmPerS) / axleMm);
    drive(() -> command);
  }

  /** The same, from any thread; what {@code command} is, is asked for on the world's strand. */
  void drive(Supplier<WheelCommand> command) {
    strand.post(() -> chassis.drive(command.get()));
  }

  /** What it touches now. From any thread. */
  Bumps bumps() {
    return bumps;
  }

  /** From now on is called, on the world's strand, when {@link #bumps} has changed. */
  void onBump(Runnable receiver) {
    bumped = receiver;
  }

  @Override
  public Senses senses(long atNs) {
    Bumps now = bumps;
    return Senses.bumps(
        now == Bumps.LEFT || now == Bumps.BOTH, now == Bumps.RIGHT || now == Bumps.BOTH);
  }

  /** Puts it where it starts, if there is room; where it is on the floor, it stays. World's strand. */
  boolean place(double apartMm) {
    if (body != null) {
      return true;
    }
    boolean[] isFree = {world.isFree(start, radiusMm)};
    world.forEachWithin(start.at(), apartMm, other -> isFree[0] = false);
    if (isFree[0]) {
      body = world.add(id, start, radiusMm);
      chassis.mount(body);
    }
    return isFree[0];
  }

  /** Takes it off the floor. World's strand. */
  void lift() {
    if (body != null) {
      lastPose = body.pose();
      chassis.unmount();
      world.remove(body);
      body = null;
      bumps = Bumps.NONE;
    }
  }

  /** As cameras see it: off the floor not at all. World's strand. */
  PoseSource.Body seen() {
    if (body != null) {
      lastPose = body.pose();
    }
    return new PoseSource.Body(rigidBody, lastPose, body != null, 0);
  }
}
