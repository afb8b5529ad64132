package org.starl.robot.optitrack;

import java.nio.BufferOverflowException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.time.Time;

/**
 * Writes a server's frames and descriptions, in one version. The layout is that of the
 * published depacketization samples of the NatNet SDK. One thread at a time.
 */
final class StreamEncoder {

  /** The positions of a body's markers, in metres from its pivot along the stream's axes. */
  private static final double[][] MARKERS = {{0.05, 0, 0}, {0, 0.05, 0.05}, {-0.05, 0, 0.05}};

  private static final double MARKER_SIZE_M = 0.014;
  private static final int POINT_CLOUD_SOLVED = 2;
  private static final int HAS_MODEL = 8;
  private static final int MODELS_CHANGED = 2;
  private static final int NO_PARENT = -1;

  private final NatNetVersion version;
  private final Axes axes;
  private final LittleEndianWriter out = new LittleEndianWriter();
  private final Map<String, Integer> ids = new LinkedHashMap<>();

  StreamEncoder(NatNetVersion version, Axes axes) {
    this.version = version;
    this.axes = axes;
  }

  /** Numbers new bodies; returns whether there were any. */
  boolean addNew(PoseSource.Snapshot snapshot) {
    int before = ids.size();
    for (PoseSource.Body body : snapshot.bodies()) {
      ids.putIfAbsent(body.name(), ids.size() + 1);
    }
    return ids.size() > before;
  }

  /** The frame's datagram; each body has been seen by {@link #addNew}. Times are ns, ticks too. */
  byte[] frame(int number, PoseSource.Snapshot snapshot, boolean hasNewModels, long nowNs) {
    try {
      out.begin(Message.FRAME).i32(number);
      writeMarkerSets(snapshot.bodies());
      writeEmptySection();
      writeBodies(snapshot.bodies());
      writeEmptySection();
      if (version.tellsSizes()) {
        writeEmptySection();
      }
      writeLabelledMarkers(snapshot.bodies());
      writeEmptySection();
      writeEmptySection();
      out.i32(0).i32(0).f64(Time.seconds(snapshot.atNs()));
      out.i64(snapshot.atNs()).i64(snapshot.atNs()).i64(nowNs);
      if (version.tellsSizes()) {
        out.i32(0).i32(0);
      }
      out.u16(hasNewModels ? MODELS_CHANGED : 0).i32(0);
      return out.end();
    } catch (BufferOverflowException e) {
      throw LittleEndianWriter.tooLong(e);
    }
  }

  /** The descriptions of these bodies, and of a set of all markers. */
  byte[] models(List<PoseSource.Body> bodies) {
    try {
      out.begin(Message.MODELS).i32(bodies.size() + 1).i32(Description.MARKER_SET);
      int start = out.beginSection(version.tellsSizes());
      out.name("all").i32(bodies.size() * MARKERS.length);
      for (PoseSource.Body body : bodies) {
        writeMarkerNames(body.name() + "_");
      }
      out.endSection(start);
      for (PoseSource.Body body : bodies) {
        out.i32(Description.RIGID_BODY);
        start = out.beginSection(version.tellsSizes());
        writeModel(body);
        out.endSection(start);
      }
      return out.end();
    } catch (BufferOverflowException e) {
      throw LittleEndianWriter.tooLong(e);
    }
  }

  private void writeModel(PoseSource.Body body) {
    out.name(body.name()).i32(id(body)).i32(NO_PARENT).f32(0).f32(0).f32(0);
    if (version.isAtLeast(NatNetVersion.V4_2)) {
      out.f32(0).f32(0).f32(0).f32(1);
    }
    out.i32(MARKERS.length);
    for (double[] marker : MARKERS) {
      out.f32(marker[0]).f32(marker[1]).f32(marker[2]);
    }
    for (int i = 0; i < MARKERS.length; i++) {
      out.i32(0);
    }
    if (version.isAtLeast(NatNetVersion.V4_0)) {
      writeMarkerNames("");
    }
  }

  private void writeMarkerNames(String prefix) {
    for (int i = 0; i < MARKERS.length; i++) {
      out.name(prefix + "Marker" + (i + 1));
    }
  }

  private void writeMarkerSets(List<PoseSource.Body> bodies) {
    out.i32(1);
    int start = out.beginSection(version.tellsSizes());
    out.name("all").i32(bodies.size() * MARKERS.length);
    for (PoseSource.Body body : bodies) {
      RigidBodyState state = state(body);
      for (double[] marker : MARKERS) {
        writeMarker(state, marker);
      }
    }
    out.endSection(start);
  }

  private void writeBodies(List<PoseSource.Body> bodies) {
    out.i32(bodies.size());
    int start = out.beginSection(version.tellsSizes());
    for (PoseSource.Body body : bodies) {
      state(body).write(out);
    }
    out.endSection(start);
  }

  private void writeLabelledMarkers(List<PoseSource.Body> bodies) {
    int tracked = 0;
    for (PoseSource.Body body : bodies) {
      tracked += body.isTracked() ? 1 : 0;
    }
    out.i32(tracked * MARKERS.length);
    int start = out.beginSection(version.tellsSizes());
    for (PoseSource.Body body : bodies) {
      if (body.isTracked()) {
        RigidBodyState state = state(body);
        for (int i = 0; i < MARKERS.length; i++) {
          out.i32(state.id() << 16 | (i + 1));
          writeMarker(state, MARKERS[i]);
          out.f32(MARKER_SIZE_M).u16(POINT_CLOUD_SOLVED | HAS_MODEL).f32(state.meanErrorM());
        }
      }
    }
    out.endSection(start);
  }

  // Markers are not rotated with their body: only its quaternion has the orientation.
  private void writeMarker(RigidBodyState state, double[] marker) {
    out.f32(state.x() + marker[0]).f32(state.y() + marker[1]).f32(state.z() + marker[2]);
  }

  private void writeEmptySection() {
    out.i32(0);
    out.endSection(out.beginSection(version.tellsSizes()));
  }

  private RigidBodyState state(PoseSource.Body body) {
    return axes.state(id(body), body.pose(), 0, body.meanErrorMm(), body.isTracked());
  }

  private int id(PoseSource.Body body) {
    Integer id = ids.get(body.name());
    if (id == null) {
      throw new IllegalStateException(body.name() + " has no number yet");
    }
    return id;
  }
}
