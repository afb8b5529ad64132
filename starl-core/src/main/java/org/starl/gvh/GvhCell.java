package org.starl.gvh;

/**
 * The writer's side of a {@link GvhVariable}. Its owner keeps it private and hands out the variable.
 */
public final class GvhCell<T> implements GvhVariable<T> {

  private final Trace trace;
  private final String source;
  private final String name;
  private T value;

  GvhCell(Trace trace, String source, String name, T initial) {
    this.trace = trace;
    this.source = source;
    this.name = name;
    this.value = initial;
    trace.variable(source, name, initial);
  }

  @Override
  public T get() {
    return value;
  }

  /** Writes; the trace sees it only if the value differs from the one before. */
  public void set(T newValue) {
    if (!newValue.equals(value)) {
      value = newValue;
      trace.variable(source, name, newValue);
    }
  }

  @Override
  public String source() {
    return source;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String toString() {
    return source + "." + name + "=" + value;
  }
}
