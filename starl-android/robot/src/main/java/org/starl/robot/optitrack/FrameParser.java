package org.starl.robot.optitrack;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads frames of motion capture data, versions 3.0 and later. It skips all sections but the rigid
 * bodies: from 4.1 on by the size of each section, before that by its known layout. The layout is that
 * of the published depacketization samples of the NatNet SDK.
 */
final class FrameParser {

  private static final int POINT_BYTES = 12;
  private static final int LABELLED_MARKER_BYTES = 26;
  private static final int SIZED_SECTION_BYTES = 8;

  /** Skeletons, assets, labelled markers, force plates, devices. */
  private static final int SIZED_SECTIONS_AFTER_BODIES = 5;

  /** From the time code to the frame's parameters and the mark at the end, from 4.1 on. */
  private static final int SIZED_SUFFIX_BYTES = 54;

  private static final int MODELS_CHANGED = 2;

  private FrameParser() {}

  /** The frame in the payload {@code in}, by this version. */
  static MocapFrame parse(LittleEndianReader in, NatNetVersion version) {
    int numberBytes = 4;
    in.skip(numberBytes);
    List<RigidBodyState> bodies = new ArrayList<>();
    if (version.tellsSizes()) {
      boolean isExtensible = version.compareTo(NatNetVersion.V4_2) > 0;
      skipSized(in, 2);
      readSizedBodies(in, isExtensible, bodies);
      skipSized(in, SIZED_SECTIONS_AFTER_BODIES);
      while (isExtensible && in.remaining() >= SIZED_SUFFIX_BYTES + SIZED_SECTION_BYTES) {
        skipSized(in, 1);
      }
    } else {
      skipMarkerSets(in);
      in.skip((long) POINT_BYTES * in.count(POINT_BYTES));
      readBodies(in, in.count(RigidBodyState.BYTES), bodies);
      skipSkeletons(in);
      in.skip((long) LABELLED_MARKER_BYTES * in.count(LABELLED_MARKER_BYTES));
      skipAnalog(in);
      skipAnalog(in);
    }
    return suffix(in, version, bodies);
  }

  private static MocapFrame suffix(
      LittleEndianReader in, NatNetVersion version, List<RigidBodyState> bodies) {
    int timecodeBytes = 8;
    int timestampBytes = 8;
    in.skip(timecodeBytes + timestampBytes);
    long exposedTicks = in.i64();
    long collectedTicks = in.i64();
    long transmittedTicks = in.i64();
    if (version.tellsSizes()) {
      int precisionTimestampBytes = 8;
      in.skip(precisionTimestampBytes);
    }
    boolean hasNewModels = (in.u16() & MODELS_CHANGED) != 0;
    return new MocapFrame(bodies, exposedTicks, collectedTicks, transmittedTicks, hasNewModels);
  }

  private static void readBodies(LittleEndianReader in, int count, List<RigidBodyState> bodies) {
    for (int i = 0; i < count; i++) {
      bodies.add(RigidBodyState.read(in));
    }
  }

  // A later version may append fields to a body: the section's size shows how many bytes.
  private static void readSizedBodies(
      LittleEndianReader in, boolean isExtensible, List<RigidBodyState> bodies) {
    int count = in.i32();
    int size = in.i32();
    LittleEndianReader section = in.section(size);
    int stride = isExtensible && count > 0 ? size / count : RigidBodyState.BYTES;
    LittleEndianReader.require(
        count >= 0
            && stride >= RigidBodyState.BYTES
            && (long) stride * count <= size
            && (!isExtensible || count == 0 || stride * count == size));
    for (int i = 0; i < count; i++) {
      bodies.add(RigidBodyState.read(section.section(stride)));
    }
  }

  private static void skipSized(LittleEndianReader in, int sections) {
    for (int i = 0; i < sections; i++) {
      in.i32();
      in.skip(in.i32());
    }
  }

  private static void skipMarkerSets(LittleEndianReader in) {
    int nameAndCountBytes = 5;
    int sets = in.count(nameAndCountBytes);
    for (int i = 0; i < sets; i++) {
      in.skipName();
      in.skip((long) POINT_BYTES * in.count(POINT_BYTES));
    }
  }

  private static void skipSkeletons(LittleEndianReader in) {
    int idAndCountBytes = 8;
    int skeletons = in.count(idAndCountBytes);
    for (int i = 0; i < skeletons; i++) {
      in.i32();
      in.skip((long) RigidBodyState.BYTES * in.count(RigidBodyState.BYTES));
    }
  }

  /** Force plates or devices: each has channels, each of these values. */
  private static void skipAnalog(LittleEndianReader in) {
    int idAndCountBytes = 8;
    int valueBytes = 4;
    int devices = in.count(idAndCountBytes);
    for (int i = 0; i < devices; i++) {
      in.i32();
      int channels = in.count(valueBytes);
      for (int j = 0; j < channels; j++) {
        in.skip((long) valueBytes * in.count(valueBytes));
      }
    }
  }
}
