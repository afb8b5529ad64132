package org.starl.gvh;

/**
 * The writable side of a {@link GvhVariable}: its owner keeps the cell private and publishes the
 * variable.
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

  /** Sets the value; the trace records it if it differs from the previous one. */
  public void set(T newValue) {
    if (newValue != value && !newValue.equals(value)) {
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
