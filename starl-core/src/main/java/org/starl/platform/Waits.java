package org.starl.platform;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * A call of an app that may wait several times in turn, such as for a mutex, written once for apps that
 * block and for apps that suspend. It is for one use, by {@link #block}, or by {@code await} of {@code
 * SuspendedThread}; nothing happens before. Strand only.
 *
 * @param <T> what the call returns
 */
public final class Waits<T> {

  private @Nullable BooleanSupplier condition;
  private long untilNs;
  private @Nullable Consumer<Boolean> then;
  private @Nullable T result;

  /**
   * @param call begins it: either ends it by {@link #end}, or waits by {@link #until}
   */
  public Waits(Consumer<Waits<T>> call) {
    then = held -> call.accept(this);
  }

  /**
   * Waits as {@link Strand#suspendUntil} does, and goes on with {@code next}, which gets whether the
   * condition held. The caller returns after this.
   */
  public void until(
      @Nullable BooleanSupplier newCondition, long newUntilNs, Consumer<Boolean> next) {
    condition = newCondition;
    untilNs = newUntilNs;
    then = next;
  }

  /** Ends the call. The caller returns after this. */
  public void end(T newResult) {
    result = newResult;
  }

  /** Runs the call on the thread of a blocking app. */
  public T block(Strand strand) {
    boolean held = false;
    while (!goOn(held)) {
      BooleanSupplier awaited = condition;
      if (awaited == null) {
        strand.sleepUntil(untilNs);
      }
      held = awaited != null && strand.awaitUntil(awaited, untilNs);
    }
    return result();
  }

  /**
   * Runs the call to its next wait, which the caller does, or to its end.
   *
   * @param held false at its start; later whether the condition of the last wait held
   * @return whether it has ended
   */
  public boolean goOn(boolean held) {
    Consumer<Boolean> next = then;
    if (next == null) {
      throw new IllegalStateException("the call has ended: expected a new one");
    }
    then = null;
    next.accept(held);
    return then == null;
  }

  /** The condition of the wait that {@link #goOn} has come to; null if it waits for the time alone. */
  public @Nullable BooleanSupplier condition() {
    return condition;
  }

  /** The end of that wait. */
  public long untilNs() {
    return untilNs;
  }

  /** What the call returned. */
  public T result() {
    if (result == null) {
      throw new IllegalStateException("the call has not ended");
    }
    return result;
  }
}
