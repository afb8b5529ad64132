package org.starl.primitives.paths;

import java.util.List;

/** A list of tubes as the gvh and the trace show it. */
record Holdings(List<Tube> tubes) {

  Holdings {
    tubes = List.copyOf(tubes);
  }

  @Override
  public String toString() {
    return Tube.text(tubes);
  }
}
