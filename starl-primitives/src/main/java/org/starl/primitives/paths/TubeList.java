package org.starl.primitives.paths;

import java.util.List;

/** The value of the variable {@code held}: a list of tubes with its text for the trace. */
record TubeList(List<Tube> tubes) {

  TubeList {
    tubes = List.copyOf(tubes);
  }

  @Override
  public String toString() {
    return Tube.text(tubes);
  }
}
