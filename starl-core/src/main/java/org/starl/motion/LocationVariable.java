package org.starl.motion;

import org.starl.gvh.GvhVariable;

/** {@code currentlocation}: computed when it is read, so that a fix allocates nothing. */
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
