package org.starl.gvh;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** All variables of one robot's gvh, in the order in which they were made. Strand only. */
public final class Variables {

  private final Trace trace;
  private final List<GvhVariable<?>> all = new ArrayList<>();

  /** @param trace records each variable's initial value and each change */
  public Variables(Trace trace) {
    this.trace = trace;
  }

  /** A new variable, and the right to write it. */
  public <T> GvhCell<T> variable(String source, String name, T initial) {
    GvhCell<T> cell = new GvhCell<>(trace, source, name, initial);
    all.add(cell);
    return cell;
  }

  /** Adds a variable whose owner computes its value when it is read. */
  public void register(GvhVariable<?> variable) {
    all.add(variable);
  }

  /** Every variable so far; a view. */
  public List<GvhVariable<?>> all() {
    return Collections.unmodifiableList(all);
  }
}
