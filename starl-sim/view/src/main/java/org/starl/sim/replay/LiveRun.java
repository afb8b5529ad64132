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
 * A simulation on its own thread, recorded in a {@link Recording}. It runs no farther than {@link
 * #runUntil} allows, so that an intervention takes effect close to the moment on the screen. All
 * methods are thread-safe; {@link #close} ends the run.
 *
 * <p>Only {@link #fault}, {@link #point}, and {@link #close} before the end change the run. Each is
 * an event of the run, and takes effect between two steps, also while the run waits.
 */
public final class LiveRun implements AutoCloseable {

  private final Simulation simulation;
  private final Recording recording;
  private final Thread thread;
  private final Queue<Request> requests = new ConcurrentLinkedQueue<>();
  private final Object requestAdded = new Object();
  private volatile long limitNs;
  // Used only by the run's thread.
  private boolean isStopped;
  private volatile @Nullable SimResult result;
  private volatile @Nullable RuntimeException failure;

  /** An intervention, and its outcome. */
  private record Request(Consumer<RunController> what, CompletableFuture<Long> whenDone) {}

  /**
   * Prepares a run; {@link #start} starts it.
   *
   * @param builder the simulation with all observers except {@code recording}; do not use it
   *     afterwards
   */
  public LiveRun(Simulation.Builder builder, Recording recording) {
    this.recording = recording;
    simulation = builder.observer(recording).stepListener(new StepGate()).build();
    thread = new Thread(this::run, "simulation");
    thread.setDaemon(true);
  }

  /** Starts the run; to be called once. */
  public void start() {
    thread.start();
  }

  /**
   * Sets the time until which the run may go on; it waits there. {@code Long.MAX_VALUE} lets it go
   * to its end. A run that is already later waits.
   */
  public void runUntil(long timeNs) {
    limitNs = timeNs;
    wake();
  }

  /**
   * Injects a fault. It begins now unless it names a time.
   *
   * @param fault in the syntax of {@code --fault}
   * @return simulated time of the injection; fails with {@link BadInput} if the fault names an
   *     unknown robot or ends before it begins, and with {@link IllegalStateException} if the run
   *     has ended
   * @throws BadInput if the syntax is wrong
   */
  public CompletableFuture<Long> fault(String fault) {
    FaultGrammar.parse(fault);
    return request(controller -> controller.fault(fault));
  }

  /**
   * Sends a point to a robot's app.
   *
   * @return simulated time of the sending; fails with {@link BadInput} if there is no such robot,
   *     and with {@link IllegalStateException} if the run has ended
   */
  public CompletableFuture<Long> point(RobotId robot, int xMm, int yMm) {
    return request(controller -> controller.point(robot, xMm, yMm));
  }

  /** Whether the run has ended; then {@link #result} or {@link #failure} is not null. */
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
   * Ends the run now, unless it has ended, and waits for its thread; returns early with the
   * interrupt flag set if the calling thread is interrupted.
   */
  @Override
  public void close() {
    if (thread.getState() == Thread.State.NEW) {
      return;
    }
    if (!isOver()) {
      enqueue(
          new Request(
              controller -> {
                controller.stop();
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

  private CompletableFuture<Long> request(Consumer<RunController> what) {
    Request request = new Request(what, new CompletableFuture<>());
    enqueue(request);
    return request.whenDone();
  }

  private void enqueue(Request request) {
    requests.add(request);
    wake();
    if (isOver()) {
      refuseAll();
    }
  }

  private void wake() {
    synchronized (requestAdded) {
      requestAdded.notifyAll();
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
    for (Request request = requests.poll(); request != null; request = requests.poll()) {
      request.whenDone().completeExceptionally(new IllegalStateException("the run has ended"));
    }
  }

  /** Lets the run wait at its limit, and carries out interventions. */
  private final class StepGate implements StepListener {
    @Override
    public void onStep(RunController controller) {
      long nowNs = controller.nowNs();
      recording.reached(nowNs);
      while (!isStopped && (nowNs >= limitNs || !requests.isEmpty())) {
        Request request = requests.poll();
        if (request != null) {
          carryOut(request, controller);
        } else {
          await(nowNs);
        }
      }
    }

    private void carryOut(Request request, RunController controller) {
      try {
        request.what().accept(controller);
        request.whenDone().complete(controller.nowNs());
      } catch (RuntimeException e) {
        request.whenDone().completeExceptionally(e);
        if (!(e instanceof BadInput)) {
          throw e; // ends the run
        }
      }
    }

    private void await(long nowNs) {
      synchronized (requestAdded) {
        try {
          while (nowNs >= limitNs && requests.isEmpty()) {
            requestAdded.wait();
          }
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IllegalStateException("the run's thread was interrupted", e);
        }
      }
    }
  }
}
