package org.starl.cli.run;

import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ProgressLine;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * Shows the progress of one long run, in simulated time up to its limit. Shows nothing for a run
 * that takes less than 2 s.
 */
final class RunProgress implements SimObserver {

  private static final long QUIET_NS = 2 * Time.NS_PER_S;

  /** Reading the clock costs as much as a small event. */
  private static final int CHECK_EVERY = 512;

  private final ProgressLine line;
  private final long plannedS;
  private long events;

  RunProgress(ProgressLine line, long endNs) {
    this.line = line;
    plannedS = Math.max(1, endNs / Time.NS_PER_S);
  }

  /** The progress of the run that {@code simulation} will build. */
  static RunProgress of(Simulation.Builder simulation, BaseCommand command) {
    ProgressLine line = command.progress("simulated seconds at most");
    RunProgress progress = new RunProgress(line, simulation.endNs());
    simulation.observer(progress);
    return progress;
  }

  @Override
  public void observed(TraceEvent event) {
    events++;
    if (events % CHECK_EVERY == 0 && line.elapsedNs() >= QUIET_NS) {
      line.show(Math.min(event.timeNs() / Time.NS_PER_S, plannedS), plannedS);
    }
  }

  @Override
  public void finished(SimResult result) {
    end();
  }

  /** Ends the line; also call it after an error. */
  void end() {
    line.end();
  }
}
