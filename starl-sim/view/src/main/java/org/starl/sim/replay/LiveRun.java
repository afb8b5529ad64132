package org.starl.sim.replay;

import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.RunController;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.StepListener;
import org.starl.sim.fault.FaultGrammar;

/**
 * A simulation that runs on its own thread and fills a {@link Recording} for a viewer. It runs no
 * farther than {@link #runUntil} allows, so that a person's interventions happen near the displayed
 * time. All methods may be called from any thread; {@link #close} ends the run.
 *
 * <p>Only {@link #fault}, {@link #point} and a {@link #close} before the end change the run; each
 * is an event of the run. It takes effect between two steps, at the time that the run has reached,
 * even while the run is paused.
 */
public final class LiveRun implements AutoCloseable {

  private final Simulation simulation;
  private final Recording recording;
  private final Thread thread;
  private final Queue<Wish> wishes = new ConcurrentLinkedQueue<>();
  private final Object newWish = new Object();
  private volatile long limitNs;
  // The run's thread's own.
  private boolean isStopped;
  private volatile @Nullable SimResult result;
  private volatile @Nullable RuntimeException failure;

  /** A requested intervention, and the future of its caller. */
  private record Wish(Consumer<RunController> what, CompletableFuture<Long> whenDone) {}

  /**
   * The run starts paused at its beginning, until {@link #start}.
   *
   * @param builder of the simulation, with all observers except {@code recording}; it is used up
   */
  public LiveRun(Simulation.Builder builder, Recording recording) {
    this.recording = recording;
    simulation = builder.observer(recording).bystander(new Pace()).build();
    thread = new Thread(this::run, "simulation");
    thread.setDaemon(true);
  }

  /** Lets it begin, once; it goes as far as {@link #runUntil} has said by then. */
  public void start() {
    thread.start();
  }

  /**
   * Lets the run continue until that time, where it pauses; {@code Long.MAX_VALUE} means until its
   * end. A run that is already farther pauses at once.
   */
  public void runUntil(long timeNs) {
    limitNs = timeNs;
    wake();
  }

  /**
   * Injects a fault from now on.
   *
   * @param fault in the format of {@code --fault}; times count from now unless it sets them
   * @return the time of the fault, or {@link BadInput} if it names no robot of this run or ends
   *     before it begins, or {@link IllegalStateException} if the run has ended
   * @throws BadInput at once if the text is not a fault
   */
  public CompletableFuture<Long> fault(String fault) {
    FaultGrammar.parse(fault);
    return wish(hands -> hands.fault(fault));
  }

  /**
   * Passes a point to a robot's app.
   *
   * @return the time of the intervention, or {@link BadInput} if there is no such robot, or {@link
   *     IllegalStateException} if the run has ended
   */
  public CompletableFuture<Long> point(RobotId robot, int xMm, int yMm) {
    return wish(hands -> hands.point(robot, xMm, yMm));
  }

  /** Whether the run has ended: {@link #result} or {@link #failure} tells how. */
  public boolean isOver() {
    return recording.isOver();
  }

  /** The result of the run; null before its end, and if an error ended it. */
  public @Nullable SimResult result() {
    return result;
  }

  /** The error that ended the run, or null. */
  public @Nullable RuntimeException failure() {
    return failure;
  }

  /**
   * Ends the run now, unless it has ended, and waits for the end of its thread. An interrupt of the
   * calling thread ends the wait and remains set.
   */
  @Override
  public void close() {
    if (thread.getState() == Thread.State.NEW) {
      return;
    }
    if (!isOver()) {
      enqueue(
          new Wish(
              hands -> {
                hands.stop();
                isStopped = true;
              },
              new CompletableFuture<>()));
    }
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private CompletableFuture<Long> wish(Consumer<RunController> what) {
    Wish wish = new Wish(what, new CompletableFuture<>());
    enqueue(wish);
    return wish.whenDone();
  }

  private void enqueue(Wish wish) {
    wishes.add(wish);
    wake();
    if (isOver()) {
      refuseAll();
    }
  }

  private void wake() {
    synchronized (newWish) {
      newWish.notifyAll();
    }
  }

  private void run() {
    try {
      result = simulation.run();
    } catch (RuntimeException e) {
      failure = e;
      recording.failed("The simulation failed: " + e.getMessage());
    } finally {
      recording.over(recording.endNs());
      refuseAll();
    }
  }

  private void refuseAll() {
    for (Wish wish = wishes.poll(); wish != null; wish = wishes.poll()) {
      wish.whenDone().completeExceptionally(new IllegalStateException("the run has ended"));
    }
  }

  /** Holds the run back, and does what is wished. */
  private final class Pace implements StepListener {
    @Override
    public void onStep(RunController hands) {
      long nowNs = hands.nowNs();
      recording.reached(nowNs);
      while (!isStopped && (nowNs >= limitNs || !wishes.isEmpty())) {
        Wish wish = wishes.poll();
        if (wish != null) {
          fulfil(wish, hands);
        } else {
          await(nowNs);
        }
      }
    }

    private void fulfil(Wish wish, RunController hands) {
      try {
        wish.what().accept(hands);
        wish.whenDone().complete(hands.nowNs());
      } catch (BadInput e) {
        wish.whenDone().completeExceptionally(e);
      }
    }

    private void await(long nowNs) {
      synchronized (newWish) {
        try {
          while (nowNs >= limitNs && wishes.isEmpty()) {
            newWish.wait();
          }
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IllegalStateException("the run's thread was interrupted", e);
        }
      }
    }
  }
}
