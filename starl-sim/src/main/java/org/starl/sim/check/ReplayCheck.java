package org.starl.sim.check;

import java.io.IOException;
import java.io.InputStream;
import org.jspecify.annotations.Nullable;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.sim.TraceRecorder;
import org.starl.sim.check.Determinism.Difference;

/**
 * Runs a simulation and compares it with a trace, byte by byte.
 *
 * @param lines the number of equal lines, from the first one on
 * @param difference the first line that differs, or null if all are equal
 * @param failure the error that ended the run, or null
 */
public record ReplayCheck(
    long lines, @Nullable Difference difference, @Nullable SimulationFailed failure) {

  /** Whether the run equals the trace. */
  public boolean isEqual() {
    return difference == null && failure == null;
  }

  /**
   * @param simulation the simulation to compare, interventions included; it is executed
   * @param trace buffered; closed by its owner
   * @throws IOException if {@code trace} cannot be read
   */
  public static ReplayCheck of(Simulation.Builder simulation, InputStream trace)
      throws IOException {
    LineComparer comparer = new LineComparer(trace);
    SimulationFailed failure = null;
    try (TraceRecorder recorder = new TraceRecorder(comparer)) {
      simulation.observer(comparer).observer(recorder).build().run();
    } catch (SimulationFailed e) {
      failure = e;
    }
    Difference difference = comparer.difference("trace", "replay");
    return new ReplayCheck(comparer.equalLines(), difference, failure);
  }
}
