package org.starl.motion;

import org.starl.gvh.GvhVariable;
import org.starl.trace.Instance;

/** {@code currentlocation}: computed when it is read, so that a fix allocates nothing. */
record LocationVariable(Gps gps) implements GvhVariable<Location> {

  @Override
  public Location get() {
    return gps.location();
  }

  @Override
  public Instance source() {
    return Deviation.SOURCE;
  }

  @Override
  public String name() {
    return "currentlocation";
  }
}
