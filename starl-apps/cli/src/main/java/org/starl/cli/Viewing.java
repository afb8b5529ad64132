package org.starl.cli;

import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceReading;
import org.starl.sim.view.Window;
import picocli.CommandLine.Option;

/** A window on a run, or on a trace. */
final class Viewing {

  @Option(names = "--dark", description = "Of the window: dark at first; D changes it.")
  private boolean dark;

  /** What came of a run that somebody watched. */
  record Watched(SimResult result, boolean isStopped) {}

  /**
   * Before anything is done that would be lost.
   *
   * @throws Lacking if this machine has no screen
   */
  static void demandScreen() {
    if (!Window.isPossible()) {
      throw new Lacking(
          "no display for a window: run it in a desktop session, or under 'xvfb-run starl ...',"
              + " or have pictures without one: 'starl record'");
    }
  }

  /**
   * Shows a trace, as far as it is one, until the window is closed.
   *
   * @throws BadInput afterwards, if it is broken somewhere
   */
  void show(TraceReading reading) {
    try (reading) {
      reading.start();
      show(reading.recording(), null);
    }
    RuntimeException failure = reading.failure();
    if (failure != null) {
      throw failure;
    }
  }

  /** Runs while somebody watches; closing the window ends the run. */
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
      throw new IllegalStateException("a run that ended without a result");
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
