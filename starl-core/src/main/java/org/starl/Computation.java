package org.starl;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Background;

/**
 * The pending result of a computation off the strand. An app waits for it with {@code
 * await(computation::isDone)}. Strand only.
 */
public final class Computation<T> {

  private @Nullable T result;
  private Runnable whenDone = () -> {};

  private Computation() {}

  static <T> Computation<T> start(Background background, Supplier<T> task) {
    Computation<T> computation = new Computation<>();
    // Written off the strand; the port orders that write before the callback on the strand.
    Box<T> box = new Box<>();
    background.submit(() -> box.value = task.get(), () -> computation.complete(box));
    return computation;
  }

  /** Whether the result is available. */
  public boolean isDone() {
    return result != null;
  }

  /**
   * The task's result.
   *
   * @throws IllegalStateException if the result is not available yet
   */
  public T result() {
    T there = result;
    if (there == null) {
      throw new IllegalStateException("no result yet: ask isDone() first");
    }
    return there;
  }

  /**
   * Sets the one listener, which runs on the strand as soon as the result is available.
   *
   * @throws IllegalStateException if the result is available already
   */
  public void whenDone(Runnable listener) {
    if (isDone()) {
      throw new IllegalStateException("whenDone: the result is available already");
    }
    whenDone = listener;
  }

  private void complete(Box<T> box) {
    if (box.value == null) {
      throw new IllegalStateException("the task returned null: expected a result");
    }
    result = box.value;
    whenDone.run();
  }

  private static final class Box<T> {
    private @Nullable T value;
  }
}
