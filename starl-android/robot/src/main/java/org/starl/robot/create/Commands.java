package org.starl.robot.create;

/** The bytes of the commands that the driver sends. */
final class Commands {

  private Commands() {}

  /**
   * Completes a command that was cut off when its link broke; no command begins with 0. Four bytes
   * complete a command of wheel speeds, as speed 0.
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

  /** Right wheel first, as the specifications have it. */
  static byte[] driveDirect(int rightMmPerS, int leftMmPerS) {
    return bytes(Opcodes.DRIVE_DIRECT, rightMmPerS >> 8, rightMmPerS, leftMmPerS >> 8, leftMmPerS);
  }

  static byte[] stream(int[] packets) {
    byte[] command = new byte[2 + packets.length];
    command[0] = (byte) Opcodes.STREAM;
    command[1] = (byte) packets.length;
    for (int i = 0; i < packets.length; i++) {
      command[2 + i] = (byte) packets[i];
    }
    return command;
  }

  static byte[] pauseStream() {
    return bytes(Opcodes.PAUSE_RESUME, 0);
  }

  static byte[] leds(int bits, int powerColour, int powerIntensity) {
    return bytes(Opcodes.LEDS, bits, powerColour, powerIntensity);
  }

  static byte[] song(int number, int[] notesAndDurations) {
    byte[] command = new byte[3 + notesAndDurations.length];
    command[0] = (byte) Opcodes.SONG;
    command[1] = (byte) number;
    command[2] = (byte) (notesAndDurations.length / 2);
    for (int i = 0; i < notesAndDurations.length; i++) {
      command[3 + i] = (byte) notesAndDurations[i];
    }
    return command;
  }

  static byte[] play(int number) {
    return bytes(Opcodes.PLAY, number);
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }
}
