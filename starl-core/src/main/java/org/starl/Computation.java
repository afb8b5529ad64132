package org.starl;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Background;

/**
 * The outcome, sooner or later, of a computation off the strand; an app waits with {@code
 * await(computation::isDone)}. Strand only.
 */
public final class Computation<T> {

  private @Nullable T result;
  private Runnable whenDone = () -> {};

  private Computation() {}

  static <T> Computation<T> start(Background background, Supplier<T> task) {
    Computation<T> computation = new Computation<>();
    // Written off the strand, read in the piece that the port runs once it has been.
    Box<T> box = new Box<>();
    background.submit(() -> box.value = task.get(), () -> computation.complete(box));
    return computation;
  }

  /** Whether the result is there. */
  public boolean isDone() {
    return result != null;
  }

  /**
   * What the task returned.
   *
   * @throws IllegalStateException if it is not there yet
   */
  public T result() {
    T there = result;
    if (there == null) {
      throw new IllegalStateException("no result yet: ask isDone() first");
    }
    return there;
  }

  /** Runs {@code listener} in the piece that brings the result; at most one, set before that. */
  public void whenDone(Runnable listener) {
    if (isDone()) {
      throw new IllegalStateException("done already");
    }
    whenDone = listener;
  }

  private void complete(Box<T> box) {
    if (box.value == null) {
      throw new IllegalStateException("a computation without result: expected anything but null");
    }
    result = box.value;
    whenDone.run();
  }

  private static final class Box<T> {
    private @Nullable T value;
  }
}
