package org.starl.robot.create;

/** The bytes of the commands that the driver sends. */
final class Commands {

  private Commands() {}

  /**
   * Zeros that complete a command that was cut off when its link broke; no command begins with 0. Four
   * of them complete a command of wheel speeds: the missing speeds are then 0.
   */
  static byte[] flush() {
    return bytes(0, 0, 0, 0);
  }

  static byte[] start() {
    return bytes(Opcodes.START);
  }

  static byte[] mode(OiMode mode) {
    return bytes(mode == OiMode.FULL ? Opcodes.FULL : Opcodes.SAFE);
  }

  /** Right wheel first, as in the specifications. */
  static byte[] driveDirect(int rightMmPerS, int leftMmPerS) {
    return bytes(Opcodes.DRIVE_DIRECT, rightMmPerS >> 8, rightMmPerS, leftMmPerS >> 8, leftMmPerS);
  }

  /** Whether a command is {@link #driveDirect}. */
  static boolean areWheelSpeeds(byte[] command) {
    return (command[0] & 0xFF) == Opcodes.DRIVE_DIRECT;
  }

  static byte[] stream(int[] packets) {
    int[] command = new int[2 + packets.length];
    command[0] = Opcodes.STREAM;
    command[1] = packets.length;
    System.arraycopy(packets, 0, command, 2, packets.length);
    return bytes(command);
  }

  /**
   * The power button's light, which shines from green over yellow to red: its colour is the part of
   * red in red and green, its intensity that of the strongest colour.
   */
  static byte[] powerLight(int rgb) {
    int red = rgb >> 16 & 0xFF;
    int green = rgb >> 8 & 0xFF;
    int intensity = Math.max(rgb & 0xFF, Math.max(red, green));
    int colour = red == 0 ? 0 : 255 * red / (red + green);
    return bytes(Opcodes.LEDS, 0, colour, intensity);
  }

  static byte[] pauseStream() {
    return bytes(Opcodes.PAUSE_RESUME, 0);
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }
}
