package org.starl.robot.create;

/** The model of a Create: its serial line, wheels and packets. */
public enum CreateModel {

  /** iRobot Create of 2006. */
  CREATE_1(57_600, 258, 42, 16),

  /** iRobot Create 2 of 2014, and Roombas of the 500 and 600 series, which have the same interface. */
  CREATE_2(115_200, 235, 58, 5);

  /** Greatest speed of a wheel in mm/s (opcode 145, both specifications). */
  public static final int MAX_WHEEL_MM_PER_S = 500;

  /** Encoder counts of one turn of a Create 2's wheel (packets 43 and 44). */
  static final double COUNTS_PER_TURN = 508.8;

  /** Diameter of a Create 2's wheel (packets 43 and 44). */
  static final double WHEEL_DIAMETER_MM = 72;

  private final int baud;
  private final double axleMm;
  private final int lastPacket;
  private final int songs;

  CreateModel(int baud, double axleMm, int lastPacket, int songs) {
    this.baud = baud;
    this.axleMm = axleMm;
    this.lastPacket = lastPacket;
    this.songs = songs;
  }

  /** Bits per second after power-up, with 8 data bits, no parity, 1 stop bit. */
  public int baud() {
    return baud;
  }

  /** Distance between the wheels. */
  public double axleMm() {
    return axleMm;
  }

  /** Number of songs that it can store, numbered from 0. */
  public int songs() {
    return songs;
  }

  /** The highest number of a packet with one value. */
  int lastPacket() {
    return lastPacket;
  }

  boolean hasEncoders() {
    return lastPacket >= Packets.RIGHT_ENCODER;
  }

  /** Path on the floor of one encoder count. */
  static double countMm() {
    return StrictMath.PI * WHEEL_DIAMETER_MM / COUNTS_PER_TURN;
  }

  /** Bytes that fit between two frames of the stream, at ten bits a byte. */
  int streamBytes() {
    return baud * Packets.STREAM_PERIOD_MS / 10_000;
  }
}
