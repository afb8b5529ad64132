package org.starl.robot.optitrack;

/** Which axis of a stream points up: a setting of Motive's streaming pane, Y unless changed. */
public enum UpAxis {
  /** The floor is the plane of x and z: our x is the stream's x, our y is its -z. */
  Y,

  /** The floor is the plane of x and y, which are ours. */
  Z
}
