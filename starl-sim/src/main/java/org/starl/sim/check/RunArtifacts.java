package org.starl.sim.check;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.starl.sim.SimulationPlan;
import org.starl.trace.Vocabulary;

/**
 * Writes files that show a run to a person, such as a picture: for tests that fail. The simulator
 * draws nothing itself; the module {@code starl-sim-view} provides an implementation, which {@link
 * #installed} finds on the class path.
 */
public interface RunArtifacts {

  /**
   * Writes the files beside the trace, with the trace's name and other endings. Files of these
   * names are replaced.
   *
   * @param trace a trace file; of a truncated one, the files show the events before the error
   * @param vocabulary the shapes of the values in the trace
   * @param plan of the same run, for its obstacles and monitors; it is not executed
   * @param failure what was wrong with the run, shown if an error ended it
   * @return the written files
   * @throws IOException if the trace cannot be read, or a file cannot be written
   */
  List<Path> write(Path trace, Vocabulary vocabulary, SimulationPlan plan, String failure)
      throws IOException;

  /**
   * Opens a window on the trace, paused at a time, and returns when it is closed.
   *
   * @param vocabulary as for {@link #write}
   * @param plan as for {@link #write}
   * @param failure as for {@link #write}
   * @param atNs in ns of virtual time
   * @throws IOException if the trace cannot be read, or there is no display
   * @throws InterruptedException if the calling thread is interrupted while it waits
   */
  void show(Path trace, Vocabulary vocabulary, SimulationPlan plan, String failure, long atNs)
      throws IOException, InterruptedException;

  /** The implementation on the class path; empty if there is none. */
  static Optional<RunArtifacts> installed() {
    return ServiceLoader.load(RunArtifacts.class).findFirst();
  }
}
