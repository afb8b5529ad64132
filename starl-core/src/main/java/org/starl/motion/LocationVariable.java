package org.starl.motion;

import org.starl.gvh.GvhVariable;

/** {@code currentlocation}: evaluated when it is read, so that a fix costs no object. */
record LocationVariable(Gps gps) implements GvhVariable<Location> {

  @Override
  public Location get() {
    return gps.location();
  }

  @Override
  public String source() {
    return "gps";
  }

  @Override
  public String name() {
    return "currentlocation";
  }
}
