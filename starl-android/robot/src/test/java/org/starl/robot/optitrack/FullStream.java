package org.starl.robot.optitrack;

import java.util.List;

/**
 * Frames and descriptions in which every section that a version has holds something, as Motive
 * streams them when all is switched on; written by hand from the published layout.
 */
final class FullStream {

  static final List<NatNetVersion> VERSIONS =
      List.of(
          NatNetVersion.V3_0,
          NatNetVersion.V3_1,
          NatNetVersion.V4_0,
          NatNetVersion.V4_1,
          NatNetVersion.V4_2);

  private final NatNetVersion version;
  private final LittleEndianWriter out = new LittleEndianWriter();

  FullStream(NatNetVersion version) {
    this.version = version;
  }

  /** With these rigid bodies, exposed at 1000 ticks, collected at 2000, sent at 3000. */
  byte[] frame(int number, List<RigidBodyState> bodies) {
    out.begin(Message.FRAME).i32(number);
    section(
        2,
        () -> {
          out.name("all").i32(2).zeros(24);
          out.name("Rigid Body").i32(0);
        });
    section(3, () -> out.zeros(36));
    section(bodies.size(), () -> bodies.forEach(body -> body.write(out)));
    section(
        1,
        () -> {
          out.i32(5).i32(2);
          out.zeros(2 * RigidBodyState.BYTES);
        });
    if (version.tellsSizes()) {
      section(1, () -> out.i32(9).i32(1).zeros(38).i32(1).zeros(30));
    }
    section(2, () -> out.zeros(2 * 26));
    section(1, () -> out.i32(1).i32(2).i32(1).f32(0.5).i32(2).f32(1).f32(2));
    section(
        2,
        () -> {
          out.i32(1).i32(0);
          out.i32(2).i32(1).i32(3).zeros(12);
        });
    out.i32(0).i32(0).f64(12.5).i64(1000).i64(2000).i64(3000);
    if (version.tellsSizes()) {
      out.i32(0).i32(0);
    }
    return out.u16(2).i32(0).end();
  }

  /** Descriptions of every kind around those of two rigid bodies, 11 Ännchen and 12 bot1. */
  byte[] models() {
    out.begin(Message.MODELS).i32(7);
    description(Description.MARKER_SET, () -> out.name("all").i32(2).name("a").name("b"));
    description(Description.RIGID_BODY, () -> body("Ännchen", 11, 0));
    description(
        Description.SKELETON,
        () -> {
          out.name("Fred").i32(1).i32(2);
          body("Hip", 1, 0);
          body("Chest", 2, 2);
        });
    description(
        Description.FORCE_PLATE,
        () -> {
          out.i32(1).name("serial").f32(1).f32(1).zeros(12);
          out.zeros(144 * 4).zeros(48).i32(0).i32(0).i32(2).name("Fx").name("Fy");
        });
    description(
        Description.DEVICE,
        () -> {
          out.i32(1).name("ADC").name("serial").i32(0).i32(0).i32(1).name("ai0");
        });
    description(Description.CAMERA, () -> out.name("Prime 13").zeros(28));
    description(Description.RIGID_BODY, () -> body("bot1", 12, 4));
    return out.end();
  }

  private void body(String name, int id, int markers) {
    out.name(name).i32(id).i32(-1).zeros(12);
    if (version.isAtLeast(NatNetVersion.V4_2)) {
      out.zeros(16);
    }
    out.i32(markers).zeros(12 * markers).zeros(4 * markers);
    if (version.isAtLeast(NatNetVersion.V4_0)) {
      for (int i = 0; i < markers; i++) {
        out.name("marker" + i);
      }
    }
  }

  private void section(int count, Runnable content) {
    out.i32(count);
    int start = out.beginSection(version.tellsSizes());
    content.run();
    out.endSection(start);
  }

  private void description(int type, Runnable content) {
    section(type, content);
  }
}
