package org.starl.sim;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.jspecify.annotations.Nullable;
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
 * @param diagnoses the first violation of each lemma, and the diagnosis at that time
 * @param faults those injected, in the order of their beginnings
 * @param failure what went wrong; null if nothing did
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
    Map<SpecReport.Violation, Diagnosis> diagnoses,
    List<InjectedFault> faults,
    @Nullable Failure failure) {

  public SimResult {
    faults = List.copyOf(faults);
    diagnoses = Collections.unmodifiableMap(new LinkedHashMap<>(diagnoses));
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
        Map.of(),
        List.of(),
        null);
  }

  /** The diagnosis of {@code violation}, if it is the first one of its lemma. */
  public Diagnosis diagnosis(SpecReport.Violation violation) {
    return diagnoses.getOrDefault(violation, Diagnosis.NONE);
  }

  /** Whether every app has ended within the time limit. */
  public boolean isFinished() {
    return unfinished.isEmpty();
  }
}
