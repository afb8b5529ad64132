package org.starl.robot.optitrack;

/** The numbers of NatNet's messages, as in its published {@code NatNetTypes.h}. */
final class Message {

  static final int CONNECT = 0;
  static final int SERVER_INFO = 1;
  static final int REQUEST = 2;
  static final int RESPONSE = 3;
  static final int REQUEST_MODELS = 4;
  static final int MODELS = 5;
  static final int FRAME = 7;
  static final int TEXT = 8;
  static final int DISCONNECT = 9;
  static final int KEEP_ALIVE = 10;
  static final int ECHO_REQUEST = 12;
  static final int ECHO_RESPONSE = 13;
  static final int DISCOVERY = 14;
  static final int UNRECOGNIZED = 100;

  /** The header of every message: its number and the size of its payload, 16 bits each. */
  static final int HEADER_BYTES = 4;

  /** The largest payload of UDP over IPv4. */
  static final int MAX_BYTES = 65_507;

  private Message() {}

  /**
   * The payload of {@code bytes[0..length)}.
   *
   * @throws java.nio.BufferUnderflowException if it is shorter than its header says
   */
  static LittleEndianReader payload(byte[] bytes, int length) {
    LittleEndianReader whole = new LittleEndianReader(bytes, 0, length);
    whole.u16();
    int size = whole.u16();
    return whole.section(size);
  }

  /** The number of the message, or -1 if it is shorter than a header. */
  static int id(byte[] bytes, int length) {
    return length < HEADER_BYTES ? -1 : (bytes[0] & 0xff) | (bytes[1] & 0xff) << 8;
  }
}
