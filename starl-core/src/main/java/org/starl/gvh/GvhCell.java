package org.starl.gvh;

import org.starl.trace.Instance;
import org.starl.trace.Var;

/**
 * A variable of the gvh, for its writer. The writer keeps the cell private, and publishes the {@link
 * #variable}: others can only read it.
 */
public final class GvhCell<T> {

  private final Trace trace;
  private final Variable<T> variable;

  GvhCell(Trace trace, Instance source, Var<T> declaration, T initial) {
    this.trace = trace;
    this.variable = new Variable<>(source, declaration, initial);
    trace.variable(source, declaration, initial);
  }

  /** What others may read. */
  public GvhVariable<T> variable() {
    return variable;
  }

  public T get() {
    return variable.value;
  }

  /** Sets the value; the trace records it if it differs from the previous one. */
  public void set(T newValue) {
    if (newValue != variable.value && !newValue.equals(variable.value)) {
      variable.value = newValue;
      trace.variable(variable.source, variable.declaration, newValue);
    }
  }

  @Override
  public String toString() {
    return variable.toString();
  }

  /** What others hold: it cannot be written. */
  static final class Variable<T> implements GvhVariable<T> {
    private final Instance source;
    final Var<T> declaration;
    private T value;

    private Variable(Instance source, Var<T> declaration, T initial) {
      this.source = source;
      this.declaration = declaration;
      this.value = initial;
    }

    @Override
    public T get() {
      return value;
    }

    @Override
    public Instance source() {
      return source;
    }

    @Override
    public String name() {
      return declaration.name();
    }

    @Override
    public String toString() {
      return source + "." + declaration + "=" + value;
    }
  }
}
