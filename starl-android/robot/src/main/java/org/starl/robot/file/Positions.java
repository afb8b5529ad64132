package org.starl.robot.file;

import org.jspecify.annotations.Nullable;

/** The system that measures the robots' positions. */
public sealed interface Positions {

  /** Largest error of a position. */
  double errorMm();

  /** Largest error of a heading. */
  double errorRad();

  /**
   * OptiTrack, over NatNet.
   *
   * @param server address of its commands
   * @param dataPort UDP port of frames that come by multicast
   * @param multicast the group that frames are sent to; null: the server sends them to each robot
   * @param networkInterface of each robot, to the cameras: its name or address; null for the one that
   *     reaches the server
   * @param version of the protocol, as in {@code 4.1}
   * @param isYUp true if the y axis points up, false if z does
   */
  record NatNet(
      HostPort server,
      int dataPort,
      @Nullable String multicast,
      @Nullable String networkInterface,
      String version,
      boolean isYUp,
      double errorMm,
      double errorRad)
      implements Positions {}

  /**
   * Lines of JSON over UDP.
   *
   * @param port UDP port of each robot
   * @param listen address of each robot at which it receives; null for its radio's address
   * @param sender the only host whose lines are taken; null for every host
   * @param key path of the file of the lines' key, as written; null if they are not authenticated
   */
  record JsonFeed(
      int port,
      @Nullable String listen,
      @Nullable String sender,
      @Nullable String key,
      double errorMm,
      double errorRad)
      implements Positions {}

  /**
   * Topics of ROS 2, one for each robot.
   *
   * @param topic has {@link RosTopic#ROBOT} in its name
   * @param frame the fixed frame in which poses are taken
   * @param sigmas standard deviations of a message's covariance that make an error bound
   */
  record Ros2(RosTopic topic, String frame, double sigmas, double errorMm, double errorRad)
      implements Positions {}
}
