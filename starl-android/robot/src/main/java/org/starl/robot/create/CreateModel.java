package org.starl.robot.create;

/** Which robot stands at the other end: its line, its wheels, its packets. */
public enum CreateModel {

  /** iRobot Create of 2006. */
  CREATE_1(57_600, 258, 42, 16),

  /** iRobot Create 2 of 2014, and Roombas of the 500 and 600 series, which speak the same. */
  CREATE_2(115_200, 235, 58, 5);

  /** No wheel is told to turn faster, in mm/s (opcode 145, both specifications). */
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

  /** How many songs it keeps, numbered from 0. */
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

  /** What one encoder count is on the floor. */
  static double countMm() {
    return StrictMath.PI * WHEEL_DIAMETER_MM / COUNTS_PER_TURN;
  }

  /** So many bytes fit between two frames of the stream, at ten bits a byte. */
  int streamBytes() {
    return baud * Packets.STREAM_PERIOD_MS / 10_000;
  }
}
