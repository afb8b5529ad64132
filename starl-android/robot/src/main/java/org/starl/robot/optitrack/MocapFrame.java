package org.starl.robot.optitrack;

import java.util.List;

/**
 * The content of one frame of a stream.
 *
 * @param bodies the rigid bodies, in the order of the stream
 * @param exposedTicks the middle of the cameras' exposure, on the server's clock; 0 if not known
 * @param collectedTicks when the server had all cameras' images; 0 if not known
 * @param transmittedTicks just before the frame was sent; 0 if not known
 * @param hasNewModels whether the list of models has changed
 */
record MocapFrame(
    List<RigidBodyState> bodies,
    long exposedTicks,
    long collectedTicks,
    long transmittedTicks,
    boolean hasNewModels) {

  MocapFrame {
    bodies = List.copyOf(bodies);
  }
}
