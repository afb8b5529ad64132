package org.starl.gvh;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.trace.Instance;
import org.starl.trace.Var;

/** All variables of one robot's gvh, in the order in which they were made. Strand only. */
public final class Variables {

  private final Trace trace;
  private final List<GvhVariable<?>> all = new ArrayList<>();

  /** @param trace records each variable's initial value and each change */
  public Variables(Trace trace) {
    this.trace = trace;
  }

  /**
   * A new variable, and the right to write it.
   *
   * @throws IllegalStateException if it has a writer already
   */
  public <T> GvhCell<T> variable(Instance source, Var<T> declaration, T initial) {
    for (GvhVariable<?> other : all) {
      if (other instanceof GvhCell.Variable<?> known
          && known.name().equals(declaration.name())
          && known.source().equals(source)) {
        throw new IllegalStateException(
            String.format(
                "variable %s.%s, declared at %s: it has a writer already, by the declaration at %s;"
                    + " expected one writer",
                source, declaration, declaration.place(), known.declaration.place()));
      }
    }
    GvhCell<T> cell = new GvhCell<>(trace, source, declaration, initial);
    all.add(cell.variable());
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
