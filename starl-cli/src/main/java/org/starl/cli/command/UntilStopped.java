package org.starl.cli.command;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * What a signal that stops this process (Ctrl-C, SIGTERM) does to the command that runs. The exit
 * status is then the JVM's, 130 or 143. A command whose work cannot end early is told of in a line;
 * others end in order, and print what they have.
 */
public final class UntilStopped {

  private static final long LIMIT_S = 10;

  /** The JVM's exit status after Ctrl-C. */
  private static final int INTERRUPTED = 130;

  /** Work that ends when its thread is interrupted. */
  @FunctionalInterface
  public interface Work {
    void run() throws InterruptedException;
  }

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Runnable otherwise;
  private volatile Runnable stop;
  private volatile Supplier<String> progress = () -> "";
  private volatile boolean isStopped;

  /**
   * @param otherwise called from another thread if the command cannot end early, with what was done;
   *     the process then ends at once
   */
  public UntilStopped(Consumer<String> otherwise) {
    this.otherwise = () -> otherwise.accept(progress.get());
    stop = this.otherwise;
  }

  /**
   * Tells what a command that cannot end early has done.
   *
   * @param done {@code 3 of 5 runs}, or empty; asked from another thread
   */
  public void progress(Supplier<String> done) {
    progress = done;
  }

  /** Waits for signals; without this, none comes. */
  public void listen() {
    Runtime.getRuntime().addShutdownHook(new Thread(this::signal, "stopped"));
  }

  private void signal() {
    if (ended.getCount() == 0) {
      return;
    }
    isStopped = true;
    Runnable action = stop;
    action.run();
    try {
      // After that the process ends as it is, with the signal's status.
      boolean hasEnded = action == otherwise || ended.await(LIMIT_S, TimeUnit.SECONDS);
      if (!hasEnded) {
        otherwise.run();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Ends this process as Ctrl-C does, for a library that has taken that signal. Does not return.
   *
   * @return nothing: for {@code throw}
   */
  public IllegalStateException signalled() {
    System.exit(INTERRUPTED);
    return new IllegalStateException("goes on after the end of the process");
  }

  /** Whether a signal has come before the command ended. */
  public boolean isStopped() {
    return isStopped;
  }

  /**
   * From now on, a signal calls {@code action} from another thread, and the process ends when the
   * command has ended.
   */
  public void calls(Runnable action) {
    stop = action;
  }

  /** From now on, the command asks {@link #isStopped} between steps, and then ends. */
  public void endsWhenAsked() {
    calls(() -> {});
  }

  /**
   * Does work that a signal interrupts; afterwards the command asks {@link #isStopped}.
   *
   * @return false if a signal has interrupted it
   */
  public boolean completes(Work work) throws InterruptedException {
    calls(Thread.currentThread()::interrupt);
    try {
      work.run();
      return true;
    } catch (InterruptedException e) {
      if (!isStopped) {
        throw e;
      }
      return false;
    } finally {
      endsWhenAsked();
      Thread.interrupted(); // a signal may come just after the work
    }
  }

  /** Call this when the command has ended, and all is printed. */
  public void ended() {
    ended.countDown();
  }
}
