package org.starl.robot.create;

/**
 * Sensor packets: numbers from 7 have one value each, the others are groups of neighbours.
 *
 * <pre>
 * packet                bytes  content
 * 7  bumps, drops       1      bit 0 bump right, 1 bump left, 2 drop right, 3 drop left, 4 drop caster
 * 8  wall               1      0 or 1
 * 9-12 cliffs           1      left, front left, front right, right: 0 or 1
 * 13 virtual wall       1      0 or 1
 * 19 distance           2      signed mm since the last query (Create 1: the driver's odometry)
 * 20 angle              2      signed degrees counter-clockwise, as 19
 * 21 charging state     1      0 not charging .. 5 fault
 * 22 voltage            2      mV
 * 23 current            2      signed mA, negative out of the battery
 * 25 charge             2      mAh
 * 26 capacity           2      mAh
 * 34 charging sources   1      bit 0 internal charger, 1 home base
 * 35 mode               1      0 off, 1 passive, 2 safe, 3 full
 * 36, 37 song           1, 1   number; 1 while playing
 * 38 stream packets     1      number of streamed packets
 * 39, 40 drive          2, 2   speed and radius last commanded
 * 41, 42 drive direct   2, 2   right and left speed last commanded
 * 43, 44 encoders       2      left, right; counts that wrap around (Create 2)
 * 45 light bumper       1      bits 0 left, front left, centre left, centre right, front right, 5 right
 * 46-58                        its six signals, infrared, motor currents, stasis (Create 2)
 * </pre>
 */
final class Packets {

  static final int STREAM_PERIOD_MS = 15;

  /** The first byte of a frame of the stream. */
  static final int FRAME_HEADER = 19;

  static final int FIRST = 7;
  static final int LAST = 58;

  static final int BUMPS_AND_DROPS = 7;
  static final int WALL = 8;
  static final int CLIFF_LEFT = 9;
  static final int CLIFF_FRONT_LEFT = 10;
  static final int CLIFF_FRONT_RIGHT = 11;
  static final int CLIFF_RIGHT = 12;
  static final int VIRTUAL_WALL = 13;
  static final int INFRARED = 17;
  static final int DISTANCE = 19;
  static final int ANGLE = 20;
  static final int CHARGING_STATE = 21;
  static final int VOLTAGE = 22;
  static final int CURRENT = 23;
  static final int TEMPERATURE = 24;
  static final int CHARGE = 25;
  static final int CAPACITY = 26;
  static final int CHARGING_SOURCES = 34;
  static final int MODE = 35;
  static final int SONG_NUMBER = 36;
  static final int SONG_PLAYING = 37;
  static final int STREAM_PACKETS = 38;
  static final int VELOCITY = 39;
  static final int RADIUS = 40;
  static final int RIGHT_VELOCITY = 41;
  static final int LEFT_VELOCITY = 42;
  static final int LEFT_ENCODER = 43;
  static final int RIGHT_ENCODER = 44;
  static final int LIGHT_BUMPER = 45;

  /** Bytes of packets 7 to 58, a digit each. */
  private static final String BYTES =
      "111111111111" + "221221222222212111112222" + "22122222211" + "22221";

  /** First and last packet of groups 0 to 6. */
  private static final int[][] GROUPS = {
    {7, 26}, {7, 16}, {17, 20}, {21, 26}, {27, 34}, {35, 42}, {7, 42}
  };

  private Packets() {}

  /** The first single packet of {@code id}, a group or single; -1 if {@code model} has none such. */
  static int first(CreateModel model, int id) {
    int[] range = range(id);
    return range.length == 0 || range[1] > model.lastPacket() ? -1 : range[0];
  }

  /** The last single packet of {@code id}, which {@link #first} knows. */
  static int last(int id) {
    return range(id)[1];
  }

  /** Bytes of a single packet. */
  static int bytes(int id) {
    return BYTES.charAt(id - FIRST) - '0';
  }

  /** Bytes of a packet or group. */
  static int bytesOfAll(int id) {
    int sum = 0;
    for (int single = range(id)[0]; single <= range(id)[1]; single++) {
      sum += bytes(single);
    }
    return sum;
  }

  static boolean isSigned(int id) {
    return switch (id) {
      case DISTANCE, ANGLE, CURRENT, TEMPERATURE -> true;
      case VELOCITY, RADIUS, RIGHT_VELOCITY, LEFT_VELOCITY -> true;
      default -> false;
    };
  }

  private static int[] range(int id) {
    if (id >= 0 && id < GROUPS.length) {
      return GROUPS[id];
    }
    return switch (id) {
      case 100 -> new int[] {7, 58};
      case 101 -> new int[] {43, 58};
      case 106 -> new int[] {46, 51};
      case 107 -> new int[] {54, 58};
      default -> id >= FIRST && id <= LAST ? new int[] {id, id} : new int[0];
    };
  }
}
