package org.starl.robot.optitrack;

/** The axis of a stream that points up: a setting in Motive's streaming pane, by default Y. */
public enum UpAxis {
  /** The floor is the plane of x and z: our x is the stream's x, our y is its -z. */
  Y,

  /** The floor is the plane of x and y, which are ours. */
  Z
}
