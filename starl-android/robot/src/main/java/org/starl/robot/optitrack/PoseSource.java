package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.TreeSet;
import org.starl.geometry.Pose;

/** The bodies that a {@link NatNetServer} streams, of a simulated world or a test. */
@FunctionalInterface
public interface PoseSource {

  /** All bodies at a recent time. Called on the server's thread. */
  Snapshot snapshot();

  /**
   * Bodies at one time.
   *
   * @param atNs that time on the server's clock, streamed as the cameras' exposure
   * @param bodies with different names; a new body gets the next number
   */
  record Snapshot(long atNs, List<Body> bodies) {

    public Snapshot {
      bodies = List.copyOf(bodies);
      TreeSet<String> names = new TreeSet<>();
      for (Body body : bodies) {
        if (!names.add(body.name())) {
          throw new IllegalArgumentException("two bodies have the name " + body.name());
        }
      }
    }
  }

  /**
   * One rigid body.
   *
   * @param name of 1 to 255 bytes, without NUL
   * @param isTracked whether the cameras see it; if not, its pose is the last one seen
   * @param meanErrorMm the mean error that the server reports, from 0 on
   */
  record Body(String name, Pose pose, boolean isTracked, double meanErrorMm) {

    public Body {
      int bytes = name.getBytes(StandardCharsets.UTF_8).length;
      if (bytes == 0 || bytes >= LittleEndianReader.MAX_NAME_BYTES || name.indexOf('\0') >= 0) {
        throw new IllegalArgumentException(
            "the name of a body has " + bytes + " bytes: expected 1 to 255, none of them NUL");
      }
      if (!(meanErrorMm >= 0)) {
        throw new IllegalArgumentException(
            "mean error of " + name + " is " + meanErrorMm + ": expected a number from 0 on");
      }
    }
  }
}
