package org.starl;

import org.starl.platform.StableStorage;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/**
 * A variable whose value survives a restart of the robot's program: {@code gvh.plat.persistent("jobs
 * done", Shapes.INT, 0)}. {@link #set} returns at once. A crash before {@link #isFlushed} may restore
 * an earlier value, never a mixture: what must not be forgotten is flushed before it is sent or done, as
 * in {@code done.set(5); await(done::isFlushed);}. Strand only.
 *
 * @param <T> the values; one that was set is not changed without setting it again
 */
public final class Persistent<T> {

  private final StableStorage stable;
  private final String name;
  private final Shape<T> shape;
  private T value;
  private int unflushed;

  Persistent(StableStorage stable, String name, Shape<T> shape, T initial) {
    this.stable = stable;
    this.name = name;
    this.shape = shape;
    byte[] stored = stable.get(name);
    value = stored == null ? initial : read(stored);
  }

  private T read(byte[] stored) {
    try {
      WireReader in = new WireReader(stored);
      T read = shape.read(in);
      in.expectEnd();
      return read;
    } catch (WireFormatException e) {
      throw new IllegalStateException(
          "stable storage: '" + name + "': expected " + shape.describe() + ": " + e.getMessage(),
          e);
    }
  }

  /** The latest value that was set, flushed or not; at the start the stored one, else the initial one. */
  public T get() {
    return value;
  }

  /**
   * Sets and stores the value.
   *
   * @throws IllegalArgumentException if the shape cannot write it; nothing is changed then
   */
  public void set(T newValue) {
    set(newValue, () -> {});
  }

  /**
   * As {@link #set}.
   *
   * @param whenFlushed called on the strand, never inside this call, once this value or a later one
   *     survives a crash; in the order of the calls
   */
  public void set(T newValue, Runnable whenFlushed) {
    byte[] bytes = WireWriter.toBytes(out -> shape.write(newValue, out));
    value = newValue;
    unflushed++;
    stable.put(
        name,
        bytes,
        () -> {
          unflushed--;
          whenFlushed.run();
        });
  }

  /** Whether the latest value survives a crash. The initial value does, as it needs no storage. */
  public boolean isFlushed() {
    return unflushed == 0;
  }

  @Override
  public String toString() {
    return name + "=" + value;
  }
}
