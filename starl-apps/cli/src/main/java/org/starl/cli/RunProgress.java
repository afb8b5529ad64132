package org.starl.cli;

import java.io.PrintWriter;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.trace.TraceEvent;

/**
 * Tells how far one long run is, in simulated time, of which it is known when it is over at the
 * latest. Of a run that is over soon it says nothing.
 */
final class RunProgress implements SimObserver {

  private static final long NS_PER_S = 1_000_000_000;
  private static final long QUIET_NS = 2 * NS_PER_S;

  /** A look at the clock costs as much as a small event. */
  private static final int LOOK_EVERY = 512;

  private final ProgressLine line;
  private final long plannedS;
  private long events;

  RunProgress(ProgressLine line, long endNs) {
    this.line = line;
    plannedS = Math.max(1, endNs / NS_PER_S);
  }

  /** Of a run that is about to be built, which it observes from now on. */
  static RunProgress of(Simulation.Builder simulation, PrintWriter err) {
    ProgressLine line = new ProgressLine(err, "simulated seconds at most");
    RunProgress progress = new RunProgress(line, simulation.endNs());
    simulation.observer(progress);
    return progress;
  }

  @Override
  public void observed(TraceEvent event) {
    events++;
    if (events % LOOK_EVERY == 0 && line.elapsedNs() >= QUIET_NS) {
      line.show(Math.min(event.timeNs() / NS_PER_S, plannedS), plannedS);
    }
  }

  @Override
  public void finished(SimResult result) {
    end();
  }

  /** What is printed next begins on a line of its own, also if an error ended the run. */
  void end() {
    line.end();
  }
}
