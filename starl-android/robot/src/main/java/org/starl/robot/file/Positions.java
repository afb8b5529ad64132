package org.starl.robot.file;

import org.jspecify.annotations.Nullable;

/** Who measures where the robots are. */
public sealed interface Positions {

  /**
   * OptiTrack, over NatNet.
   *
   * @param server its command address
   * @param dataPort where frames come, if they come by multicast
   * @param multicast the group that frames are sent to; null: the server sends them to each robot
   * @param version of the protocol, as in {@code 4.1}
   * @param isYUp whether the y axis points up; else z does
   * @param errorMm a position is off by so much at most
   * @param errorRad a heading is off by so much at most
   */
  record NatNet(
      HostPort server,
      int dataPort,
      @Nullable String multicast,
      String version,
      boolean isYUp,
      double errorMm,
      double errorRad)
      implements Positions {}

  /**
   * Lines of JSON over UDP.
   *
   * @param port at which each robot listens
   * @param sender whose lines are taken; null for anybody's
   * @param errorMm a position is off by so much at most
   * @param errorRad a heading is off by so much at most
   */
  record JsonFeed(int port, @Nullable String sender, double errorMm, double errorRad)
      implements Positions {}
}
