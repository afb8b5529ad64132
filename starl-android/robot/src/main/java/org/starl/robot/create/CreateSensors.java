package org.starl.robot.create;

import org.starl.body.Bumps;

/**
 * The robot's last sensor frame. Immutable.
 *
 * @param cliff whether any of the four cliff sensors sees no floor
 * @param wheelDrop whether a wheel or the caster hangs down: the robot was lifted
 * @param virtualWall whether the robot sees the beam of a virtual wall
 * @param charger whether a charger with power is plugged in, or the robot stands in its home base
 * @param chargingState 0 not charging, 1 reconditioning, 2 full, 3 trickle, 4 waiting, 5 fault
 * @param batteryMv voltage of the battery in mV
 * @param batteryMa current in mA, negative out of the battery
 * @param chargeMah charge of the battery in mAh
 * @param capacityMah its capacity in mAh
 * @param travel odometry
 */
public record CreateSensors(
    OiMode mode,
    Bumps bumps,
    boolean cliff,
    boolean wheelDrop,
    boolean virtualWall,
    boolean charger,
    int chargingState,
    int batteryMv,
    int batteryMa,
    int chargeMah,
    int capacityMah,
    CreateTravel travel) {

  static final CreateSensors NONE =
      new CreateSensors(
          OiMode.OFF, Bumps.NONE, false, false, false, false, 0, 0, 0, 0, 0, CreateTravel.NONE);

  /** The packets that the driver asks for; the last has one byte that is never a frame's header. */
  static int[] packets(CreateModel model) {
    boolean hasEncoders = model.hasEncoders();
    return new int[] {
      Packets.BUMPS_AND_DROPS,
      Packets.CLIFF_LEFT,
      Packets.CLIFF_FRONT_LEFT,
      Packets.CLIFF_FRONT_RIGHT,
      Packets.CLIFF_RIGHT,
      Packets.VIRTUAL_WALL,
      Packets.CHARGING_STATE,
      Packets.VOLTAGE,
      Packets.CURRENT,
      Packets.CHARGE,
      Packets.CAPACITY,
      Packets.CHARGING_SOURCES,
      hasEncoders ? Packets.LEFT_ENCODER : Packets.DISTANCE,
      hasEncoders ? Packets.RIGHT_ENCODER : Packets.ANGLE,
      Packets.MODE
    };
  }

  static CreateSensors of(StreamDecoder frame, CreateTravel travel) {
    int bumpsAndDrops = frame.value(Packets.BUMPS_AND_DROPS);
    return new CreateSensors(
        OiMode.of(frame.value(Packets.MODE)),
        Bumps.of((bumpsAndDrops & 2) != 0, (bumpsAndDrops & 1) != 0),
        frame.value(Packets.CLIFF_LEFT) != 0
            || frame.value(Packets.CLIFF_FRONT_LEFT) != 0
            || frame.value(Packets.CLIFF_FRONT_RIGHT) != 0
            || frame.value(Packets.CLIFF_RIGHT) != 0,
        (bumpsAndDrops & 0b11100) != 0,
        frame.value(Packets.VIRTUAL_WALL) != 0,
        frame.value(Packets.CHARGING_SOURCES) != 0,
        frame.value(Packets.CHARGING_STATE),
        frame.value(Packets.VOLTAGE),
        frame.value(Packets.CURRENT),
        frame.value(Packets.CHARGE),
        frame.value(Packets.CAPACITY),
        travel);
  }

  /** Whether the robot would leave safe mode at once. */
  boolean forbidsSafeMode() {
    return wheelDrop || charger;
  }
}
