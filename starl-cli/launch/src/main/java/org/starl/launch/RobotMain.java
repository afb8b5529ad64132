package org.starl.launch;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.starl.id.RobotId;
import org.starl.robot.DeployedRobot;
import org.starl.robot.realtime.RealStrand;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimulationPlan;

/**
 * The main loop of one robot in real time. Its app runs for several rounds. Each round is a new
 * incarnation: a new start of the program over the same stable storage. After the last round the
 * robot answers messages until it is stopped.
 */
abstract class RobotMain implements DeployedRobot.Host {

  /** Work for the loop's thread. */
  @FunctionalInterface
  interface Task {
    void run() throws IOException;
  }

  private static final long STRAND_LIMIT_S = 2;

  private final Supplier<SimulationPlan> plans;
  private final int rounds;
  private final BlockingQueue<Task> tasks = new LinkedBlockingQueue<>();
  private volatile boolean isStopped;

  // The loop's thread only.
  private int round;

  final RobotId id;

  /**
   * @param plans makes equal plans, one for each round, because a director serves one run
   * @param rounds number of runs of the app, from 1
   */
  RobotMain(RobotId id, Supplier<SimulationPlan> plans, int rounds) {
    this.id = id;
    this.plans = plans;
    this.rounds = rounds;
  }

  /** Starts an incarnation; {@code number} counts from 1. On the loop's thread. */
  abstract void bringUp(SimulationPlan plan, RobotSpec spec, int number) throws IOException;

  /**
   * Ends the incarnation, if there is one. On the loop's thread.
   *
   * @param isLifted whether to remove its body from the floor, for the next round
   */
  abstract void bringDown(boolean isLifted) throws IOException;

  /** The robot of that name. */
  static RobotSpec spec(SimulationPlan plan, RobotId id) {
    return plan.robots().stream()
        .filter(spec -> spec.id().equals(id))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("there is no robot " + id));
  }

  /**
   * Runs {@code task} on a strand, and returns when it has run.
   *
   * @return false if the app does not release the strand, or the strand is closed
   */
  static boolean runOn(RealStrand strand, Runnable task) {
    CountDownLatch hasRun = new CountDownLatch(1);
    strand.post(() -> {
      task.run();
      hasRun.countDown();
    });
    try {
      return !strand.isClosed() && hasRun.await(STRAND_LIMIT_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Runs posted tasks until {@link #endLoop}. */
  final void loop() throws IOException {
    while (!isStopped) {
      try {
        tasks.take().run();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        isStopped = true;
      }
    }
  }

  /** Runs {@code task} on the loop's thread. From any thread. */
  final void post(Task task) {
    tasks.add(task);
  }

  /**
   * The loop ends after the current task. From any thread.
   *
   * @param first runs before a waiting loop is woken
   */
  final void endLoop(Runnable first) {
    isStopped = true;
    first.run();
    post(() -> {});
  }

  final boolean isStopped() {
    return isStopped;
  }

  /** Brings the next incarnation up, unless the robot is stopped already. */
  final void startRound() throws IOException {
    if (!isStopped) {
      round++;
      SimulationPlan plan = plans.get();
      bringUp(plan, spec(plan, id), round);
    }
  }

  /** Starts the next round if there is one. */
  @Override
  public void finished(List<Object> results) {
    post(() -> {
      if (round < rounds) {
        bringDown(true);
        startRound();
      }
    });
  }

  /** The current round and the number of rounds, for people. */
  final String progress() {
    return round + " of " + rounds;
  }
}
