package org.starl.trace;

import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * A variable of the gvh: its name and the shape of its values. Declare each one once, as a constant:
 * the app writes it under this constant, and monitors read it under the same one.
 *
 * <pre>{@code
 * static final Var<Integer> ROUNDS = Var.of("rounds", Shapes.INT);
 * }</pre>
 *
 * @param <T> the values; immutable, and never null
 */
public final class Var<T> {

  private final String name;
  private final Shape<T> shape;
  private final String place;

  private Var(String name, Shape<T> shape) {
    this.name = name;
    this.shape = shape;
    this.place = callerPlace();
  }

  // Once for each declaration, which is a constant.
  private static String callerPlace() {
    for (StackTraceElement frame : new Throwable().getStackTrace()) {
      if (!frame.getClassName().equals(Var.class.getName())) {
        return frame.toString();
      }
    }
    return "an unknown place";
  }

  /**
   * A variable.
   *
   * @param name the paper's spelling, as in {@code crit}; unique among those of an app or primitive
   */
  public static <T> Var<T> of(String name, Shape<T> shape) {
    return new Var<>(name, shape);
  }

  /** A variable whose values are the constants of an enum, such as an app's location. */
  public static <E extends Enum<E>> Var<E> of(String name, Class<E> constants) {
    return new Var<>(name, Shapes.constant(constants));
  }

  public String name() {
    return name;
  }

  public Shape<T> shape() {
    return shape;
  }

  /** The line of code that declares it: for errors. */
  public String place() {
    return place;
  }

  @Override
  public String toString() {
    return name;
  }
}
