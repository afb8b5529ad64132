package org.starl.robot.optitrack;

/**
 * Skips descriptions without a size, of versions before 4.1. The layout is that of the published
 * depacketization samples of the NatNet SDK.
 */
final class Description {

  static final int MARKER_SET = 0;
  static final int RIGID_BODY = 1;
  static final int SKELETON = 2;
  static final int FORCE_PLATE = 3;
  static final int DEVICE = 4;
  static final int CAMERA = 5;

  private static final int POINT_BYTES = 12;
  private static final int QUATERNION_BYTES = 16;
  private static final int LABEL_BYTES = 4;

  private Description() {}

  /** Skips a description; false, without reading, if its type is not known. */
  static boolean skip(LittleEndianReader in, int type, NatNetVersion version) {
    switch (type) {
      case MARKER_SET -> {
        in.skipName();
        in.skipNames(in.count(1));
      }
      case RIGID_BODY -> skipBody(in, version);
      case SKELETON -> skipSkeleton(in, version);
      case FORCE_PLATE -> skipForcePlate(in);
      case DEVICE -> {
        in.i32();
        in.skipNames(2);
        skipChannels(in);
      }
      case CAMERA -> {
        in.skipName();
        in.skip(POINT_BYTES + QUATERNION_BYTES);
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  /** Skips the rest of a rigid body after its number: parent, offset, markers. */
  static void skipRestOfBody(LittleEndianReader in, NatNetVersion version) {
    in.i32();
    in.skip(POINT_BYTES);
    int markers = in.count(POINT_BYTES + LABEL_BYTES);
    in.skip((long) markers * (POINT_BYTES + LABEL_BYTES));
    if (version.isAtLeast(NatNetVersion.V4_0)) {
      in.skipNames(markers);
    }
  }

  private static void skipBody(LittleEndianReader in, NatNetVersion version) {
    in.skipName();
    in.i32();
    skipRestOfBody(in, version);
  }

  private static void skipSkeleton(LittleEndianReader in, NatNetVersion version) {
    in.skipName();
    in.i32();
    int leastBodyBytes = 25;
    int bones = in.count(leastBodyBytes);
    for (int i = 0; i < bones; i++) {
      skipBody(in, version);
    }
  }

  private static void skipForcePlate(LittleEndianReader in) {
    int sizeAndOriginBytes = 20;
    int calibrationBytes = 12 * 12 * 4;
    int cornersBytes = 4 * POINT_BYTES;
    in.i32();
    in.skipName();
    in.skip(sizeAndOriginBytes + calibrationBytes + cornersBytes);
    skipChannels(in);
  }

  /** Type of device, type of data, the channels' names. */
  private static void skipChannels(LittleEndianReader in) {
    in.skip(8);
    in.skipNames(in.count(1));
  }
}
