package org.starl.robot.optitrack;

/**
 * A rigid body in a frame, in the stream's coordinates.
 *
 * @param x metres along the stream's x axis; likewise y and z
 * @param qx the orientation as a quaternion (qx, qy, qz, qw), its scalar part last
 * @param meanErrorM mean distance, in metres, of the markers from the solved body
 * @param isTracked whether the cameras saw it in this frame
 */
record RigidBodyState(
    int id,
    double x,
    double y,
    double z,
    double qx,
    double qy,
    double qz,
    double qw,
    double meanErrorM,
    boolean isTracked) {

  /** Size in a frame, from version 3.0 on. */
  static final int BYTES = 38;

  private static final int TRACKED = 1;

  static RigidBodyState read(LittleEndianReader in) {
    return new RigidBodyState(
        in.i32(),
        in.f32(),
        in.f32(),
        in.f32(),
        in.f32(),
        in.f32(),
        in.f32(),
        in.f32(),
        in.f32(),
        (in.u16() & TRACKED) != 0);
  }

  void write(LittleEndianWriter out) {
    out.i32(id).f32(x).f32(y).f32(z);
    out.f32(qx).f32(qy).f32(qz).f32(qw).f32(meanErrorM).u16(isTracked ? TRACKED : 0);
  }
}
