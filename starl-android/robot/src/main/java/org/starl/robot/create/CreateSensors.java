package org.starl.robot.create;

import java.util.ArrayList;
import java.util.List;
import org.starl.body.Bumps;

/**
 * The robot's last sensor frame. Immutable.
 *
 * @param cliff whether any of the four cliff sensors sees no floor
 * @param wheelDrop whether a wheel or the caster hangs down: the robot was lifted
 * @param virtualWall whether the robot sees the beam of a virtual wall
 * @param near bits of the proximity sensors that see something: a Create 2's light bumper, from the
 *     left in bit 0 to the right in bit 5; a Create 1's wall sensor in bit 5
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
    int near,
    boolean charger,
    int chargingState,
    int batteryMv,
    int batteryMa,
    int chargeMah,
    int capacityMah,
    CreateTravel travel) {

  private static final int NEAR_BITS = 0x3F;
  private static final int WALL_BIT = 0x20;

  /** The specifications show the sensors along the bumper, but have no angles: evenly spread. */
  private static final double[] NEAR_RAD = {
    StrictMath.PI * 5 / 12,
    StrictMath.PI * 3 / 12,
    StrictMath.PI / 12,
    -StrictMath.PI / 12,
    -StrictMath.PI * 3 / 12,
    -StrictMath.PI * 5 / 12
  };

  static final CreateSensors NONE =
      new CreateSensors(
          OiMode.OFF, Bumps.NONE, false, false, false, 0, false, 0, 0, 0, 0, 0, CreateTravel.NONE);

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
      hasEncoders ? Packets.LIGHT_BUMPER : Packets.WALL,
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
        near(frame),
        frame.value(Packets.CHARGING_SOURCES) != 0,
        frame.value(Packets.CHARGING_STATE),
        frame.value(Packets.VOLTAGE),
        frame.value(Packets.CURRENT),
        frame.value(Packets.CHARGE),
        frame.value(Packets.CAPACITY),
        travel);
  }

  private static int near(StreamDecoder frame) {
    int wall = frame.value(Packets.WALL) != 0 ? WALL_BIT : 0;
    return (frame.value(Packets.LIGHT_BUMPER) & NEAR_BITS) | wall;
  }

  /** The bearings of {@link #near}, from left to right. */
  List<Double> nearRad() {
    List<Double> bearings = new ArrayList<>();
    for (int i = 0; i < NEAR_RAD.length; i++) {
      if ((near >> i & 1) != 0) {
        bearings.add(NEAR_RAD[i]);
      }
    }
    return bearings;
  }

  /** Whether the robot would leave safe mode at once. */
  boolean forbidsSafeMode() {
    return wheelDrop || charger;
  }
}
