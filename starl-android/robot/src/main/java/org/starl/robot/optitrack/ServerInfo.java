package org.starl.robot.optitrack;

/**
 * A server's description of itself.
 *
 * @param name of the serving program
 * @param ticksPerS of the clock that stamps its frames; 0 if unknown
 * @param isMulticast whether it streams to a group
 * @param dataPort the UDP port of its stream
 * @param group the four bytes of the group's address as one number, first byte highest
 */
record ServerInfo(
    String name,
    NatNetVersion version,
    long ticksPerS,
    boolean isMulticast,
    int dataPort,
    int group) {

  private static final int NAME_BYTES = 256;
  private static final int VERSION_BYTES = 4;
  private static final int CLOCK_AND_CONNECTION_BYTES = 15;

  /** The answer in the payload {@code in}. */
  static ServerInfo parse(LittleEndianReader in) {
    String name = in.fixedName(NAME_BYTES);
    in.skip(VERSION_BYTES);
    NatNetVersion version = new NatNetVersion(in.u8(), in.u8());
    in.skip(VERSION_BYTES - 2);
    boolean isLong = in.remaining() >= CLOCK_AND_CONNECTION_BYTES;
    long ticksPerS = isLong ? in.i64() : 0;
    int dataPort = isLong ? in.u16() : 0;
    boolean isMulticast = isLong && in.u8() != 0;
    int group = isLong ? Integer.reverseBytes(in.i32()) : 0;
    return new ServerInfo(name, version, ticksPerS, isMulticast, dataPort, group);
  }

  byte[] datagram(LittleEndianWriter out) {
    out.begin(Message.SERVER_INFO).fixedName(name, NAME_BYTES);
    out.u8(1).u8(0).u8(0).u8(0);
    out.u8(version.major()).u8(version.minor()).u8(0).u8(0);
    out.i64(ticksPerS).u16(dataPort).u8(isMulticast ? 1 : 0).i32(Integer.reverseBytes(group));
    return out.end();
  }
}
