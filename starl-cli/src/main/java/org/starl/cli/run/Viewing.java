package org.starl.cli.run;

import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.MissingDependencyException;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceLoader;
import org.starl.sim.view.Window;
import picocli.CommandLine.Option;

/** Shows a run or a trace in a window. */
public final class Viewing {

  private static final long MOST_BYTES_OF_SEVERAL = 64L << 20;

  @Option(names = "--dark", description = "Dark theme of the window; key D switches it.")
  private boolean dark;

  /**
   * The result of a run in a window.
   *
   * @param isStopped whether the window was closed before the end
   */
  record Watched(SimResult result, boolean isStopped) {}

  /**
   * Checks for a display. Call it before work that would be lost.
   *
   * @throws MissingDependencyException if this machine has no display
   */
  static void requireDisplay() {
    if (!Window.isPossible()) {
      throw new MissingDependencyException(
          "no display for a window: run it in a desktop session, or under 'xvfb-run starl ...',"
              + " or write pictures without one: 'starl record'");
    }
  }

  /** A recording of a run of this plan, for one of several runs that are shown at once. */
  public static Recording recording(Plan plan) {
    return new Recording(plan.obstacles(), plan.layer().copy(), MOST_BYTES_OF_SEVERAL);
  }

  /**
   * Shows a trace, up to its first broken line, until the window is closed.
   *
   * @throws BadInput afterwards, if a line is broken
   */
  void show(TraceLoader reading) {
    try (reading) {
      reading.start();
      show(reading.recording(), null);
    }
    RuntimeException failure = reading.failure();
    if (failure != null) {
      throw failure;
    }
  }

  /** Runs the plan in a window; closing the window ends the run. */
  Watched run(Plan plan) {
    Recording recording = new Recording(plan.obstacles(), plan.layer().copy());
    LiveRun live = new LiveRun(plan.simulation(), recording);
    boolean isStopped;
    try (live) {
      live.start();
      show(recording, live);
      isStopped = !live.isOver();
    }
    return watched(live, isStopped);
  }

  private static Watched watched(LiveRun live, boolean isStopped) {
    RuntimeException failure = live.failure();
    if (failure != null) {
      throw failure;
    }
    SimResult result = live.result();
    if (result == null) {
      throw new IllegalStateException("the run ended without a result");
    }
    return new Watched(result, isStopped);
  }

  private void show(Recording recording, @Nullable LiveRun live) {
    try {
      Window.show(recording, live, dark);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while a window was open", e);
    }
  }
}
