package org.starl.motion;

import org.starl.GlobalVarHolder;
import org.starl.platform.Platform;

/** {@code gvh.gps}: where this robot is, filtered. Strand only. */
public final class Gps {

  public Gps(GlobalVarHolder gvh, Platform platform) {}
}
