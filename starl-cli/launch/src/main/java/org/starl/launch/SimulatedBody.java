package org.starl.launch;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.world.Body;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;

/** A robot's simulated body, on or off the floor. Only on the strand of its world. */
class SimulatedBody {

  private final RobotId id;
  private final Pose start;
  private final double radiusMm;
  private final boolean collides;
  private final World world;
  private final SimChassis chassis;
  private @Nullable Body body;

  SimulatedBody(RobotSpec spec, SimSettings settings, World world, SimChassis chassis) {
    id = spec.id();
    start = spec.start();
    radiusMm = settings.robotRadiusMm();
    collides = settings.worldLimits().collisions();
    this.world = world;
    this.chassis = chassis;
  }

  /** Whether the body would touch no other there. */
  final boolean isFree(Pose place) {
    return isFree(place, radiusMm);
  }

  /** The same for a disc of another radius. */
  final boolean isFree(Pose place, double ofRadiusMm) {
    return !collides || world.isFree(place, ofRadiusMm);
  }

  final double radiusMm() {
    return radiusMm;
  }

  /**
   * Puts it on the floor at its start if there is room; a body on the floor stays where it is.
   *
   * @param apartMm no other body's centre may be nearer than this
   * @return whether it is on the floor now
   */
  final boolean place(double apartMm) {
    if (body == null && isFree(start)) {
      boolean[] isNear = {false};
      world.forEachWithin(start.at(), apartMm, other -> isNear[0] = true);
      if (!isNear[0]) {
        body = world.add(id, start, radiusMm);
        chassis.mount(body);
      }
    }
    return body != null;
  }

  /** Takes it off the floor. */
  void lift() {
    if (body != null) {
      chassis.unmount();
      world.remove(body);
      body = null;
    }
  }

  final boolean isOnFloor() {
    return body != null;
  }

  /** The body on the floor. */
  final Body onFloor() {
    if (body == null) {
      throw new IllegalStateException(id + " is not on the floor");
    }
    return body;
  }

  @Override
  public final String toString() {
    return id.name();
  }
}
