package org.starl.sim;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.starl.id.RobotId;
import org.starl.sim.net.NetStatistics;
import org.starl.sim.world.Collisions;
import org.starl.spec.SpecReport;

/**
 * The result of a run.
 *
 * @param seed of the scenario
 * @param behaviourSeed of everything else
 * @param endNs virtual time of the end
 * @param events that the kernel processed
 * @param results of the apps that have ended
 * @param unfinished robots whose apps have not ended, but for robots that left or crashed for good
 * @param spec what the monitors found
 * @param diagnosis why the run has not finished
 * @param overdue the first missed deadline of each lemma, and the diagnosis at that time
 */
public record SimResult(
    long seed,
    long behaviourSeed,
    long endNs,
    long events,
    SortedMap<RobotId, List<Object>> results,
    List<RobotId> unfinished,
    NetStatistics network,
    Collisions collisions,
    SpecReport spec,
    Diagnosis diagnosis,
    Map<SpecReport.Violation, Diagnosis> overdue) {

  public SimResult {
    overdue = Collections.unmodifiableMap(new LinkedHashMap<>(overdue));
  }

  /** A result without a diagnosis, as of a recorded run. */
  public SimResult(
      long seed,
      long behaviourSeed,
      long endNs,
      long events,
      SortedMap<RobotId, List<Object>> results,
      List<RobotId> unfinished,
      NetStatistics network,
      Collisions collisions,
      SpecReport spec) {
    this(
        seed,
        behaviourSeed,
        endNs,
        events,
        results,
        unfinished,
        network,
        collisions,
        spec,
        Diagnosis.NONE,
        Map.of());
  }

  /** The diagnosis of {@code violation}, if it is a missed deadline that has one. */
  public Diagnosis diagnosis(SpecReport.Violation violation) {
    return overdue.getOrDefault(violation, Diagnosis.NONE);
  }

  /** Whether every app has ended within the time limit. */
  public boolean isFinished() {
    return unfinished.isEmpty();
  }
}
