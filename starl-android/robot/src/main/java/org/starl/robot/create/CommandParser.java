package org.starl.robot.create;

/**
 * Splits the bytes that a robot receives into commands, as the robot does: by opcode, without a
 * checksum, so that an extra or a missing byte changes the commands after it. Never throws; stores at
 * most one command. One thread.
 */
final class CommandParser {

  /** Receives complete commands. */
  interface Receiver {
    /** {@code data[0..length)} are the data bytes of {@code opcode}; valid during this call only. */
    void command(int opcode, byte[] data, int length);
  }

  private static final int NONE = -1;

  /** A song of 255 notes (more than any has) with its header. */
  private final byte[] data = new byte[2 + 2 * 255];

  private final CreateModel model;
  private int opcode = NONE;
  private int length;
  private int missing;
  private long unknown;

  CommandParser(CreateModel model) {
    this.model = model;
  }

  void accept(byte[] bytes, int count, Receiver receiver) {
    for (int i = 0; i < count; i++) {
      accept(bytes[i] & 0xFF, receiver);
    }
  }

  /** Bytes that began no command. */
  long unknown() {
    return unknown;
  }

  private void accept(int value, Receiver receiver) {
    if (opcode == NONE) {
      begin(value);
    } else {
      data[length++] = (byte) value;
      missing--;
      missing += announced(value);
    }
    if (opcode != NONE && missing == 0) {
      int complete = opcode;
      opcode = NONE;
      receiver.command(complete, data, length);
    }
  }

  private void begin(int value) {
    int count = dataBytes(value);
    if (count == NONE) {
      unknown++;
    } else {
      opcode = value;
      length = 0;
      missing = count;
    }
  }

  /** The number of further data bytes that the last byte announces. */
  private int announced(int value) {
    boolean isFirst = length == 1;
    return switch (opcode) {
      case Opcodes.SONG -> length == 2 ? 2 * value : 0;
      case Opcodes.STREAM, Opcodes.QUERY_LIST, Opcodes.SCRIPT -> isFirst ? value : 0;
      default -> 0;
    };
  }

  /** Data bytes of the command {@code value}, up to its count byte if it has one; NONE: no command. */
  private int dataBytes(int value) {
    boolean isFirst = model == CreateModel.CREATE_1;
    return switch (value) {
      case Opcodes.START, Opcodes.CONTROL, Opcodes.SAFE, Opcodes.FULL -> 0;
      case Opcodes.SPOT, Opcodes.CLEAN, Opcodes.DOCK -> 0;
      case Opcodes.DEMO -> isFirst ? 1 : 0;
      case Opcodes.BAUD, Opcodes.PLAY, Opcodes.SENSORS, Opcodes.PAUSE_RESUME -> 1;
      case 138 -> 1;
      case Opcodes.DRIVE, Opcodes.DRIVE_DIRECT -> 4;
      case Opcodes.LEDS, 144 -> 3;
      case Opcodes.SONG -> 2;
      case Opcodes.STREAM, Opcodes.QUERY_LIST -> 1;
      default -> isFirst ? dataBytesOfCreate1(value) : dataBytesOfCreate2(value);
    };
  }

  private static int dataBytesOfCreate1(int value) {
    return switch (value) {
      case 153, 154 -> 0;
      case 147, 151, Opcodes.SCRIPT, 155, 158 -> 1;
      case 156, 157 -> 2;
      default -> NONE;
    };
  }

  private static int dataBytesOfCreate2(int value) {
    return switch (value) {
      case Opcodes.RESET, Opcodes.POWER, Opcodes.STOP -> 0;
      case 165 -> 1;
      case 162 -> 2;
      case 168 -> 3;
      case Opcodes.DRIVE_PWM, 163, 164 -> 4;
      case 167 -> 15;
      default -> NONE;
    };
  }
}
