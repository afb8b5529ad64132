package org.starl.robot.optitrack;

/** A version of NatNet's stream: 3.0, 3.1, 4.0 and so on. */
public record NatNetVersion(int major, int minor) implements Comparable<NatNetVersion> {

  public static final NatNetVersion V3_0 = new NatNetVersion(3, 0);
  public static final NatNetVersion V3_1 = new NatNetVersion(3, 1);
  public static final NatNetVersion V4_0 = new NatNetVersion(4, 0);
  public static final NatNetVersion V4_1 = new NatNetVersion(4, 1);
  public static final NatNetVersion V4_2 = new NatNetVersion(4, 2);

  public NatNetVersion {
    if (major < 0 || major > 255 || minor < 0 || minor > 255) {
      throw new IllegalArgumentException(
          "NatNet version " + major + "." + minor + ": expected numbers from 0 to 255");
    }
  }

  @Override
  public int compareTo(NatNetVersion other) {
    return major != other.major
        ? Integer.compare(major, other.major)
        : Integer.compare(minor, other.minor);
  }

  boolean isAtLeast(NatNetVersion other) {
    return compareTo(other) >= 0;
  }

  /** Whether each section of a frame and each description begins with its size. */
  boolean tellsSizes() {
    return isAtLeast(V4_1);
  }

  @Override
  public String toString() {
    return major + "." + minor;
  }
}
