package org.starl.sim.check;

import java.util.ArrayList;
import java.util.List;
import org.starl.input.Quantities;
import org.starl.sim.fault.Fault;

/**
 * The parts of a run that {@link Shrink} can remove.
 *
 * @param robots number of initial robots
 * @param settings keys of the settings that are set and can be reset to their defaults
 * @param faults to inject, including those drawn by chaos
 * @param endNs latest end of the run, in ns of virtual time
 */
public record Trial(int robots, List<String> settings, List<Fault> faults, long endNs) {

  public Trial {
    settings = List.copyOf(settings);
    faults = List.copyOf(faults);
    if (robots < 0 || endNs <= 0) {
      throw new IllegalArgumentException(
          "a trial of " + robots + " robots until " + endNs + " ns: expected a time above 0");
    }
  }

  Trial withRobots(int newRobots) {
    return new Trial(newRobots, settings, faults, endNs);
  }

  Trial withEndNs(long newEndNs) {
    return new Trial(robots, settings, faults, newEndNs);
  }

  Trial withoutSetting(int index) {
    List<String> left = new ArrayList<>(settings);
    left.remove(index);
    return new Trial(robots, left, faults, endNs);
  }

  Trial withoutFaults(int from, int count) {
    List<Fault> left = new ArrayList<>(faults);
    left.subList(from, from + count).clear();
    return withFaults(left);
  }

  Trial withFaults(List<Fault> newFaults) {
    return new Trial(robots, settings, newFaults, endNs);
  }

  Trial withFault(int index, Fault fault) {
    List<Fault> changed = new ArrayList<>(faults);
    changed.set(index, fault);
    return withFaults(changed);
  }

  /** {@code 4 robots, 1 setting, 3 faults, 12.3s}. */
  @Override
  public String toString() {
    return count(robots, "robot")
        + (settings.isEmpty() ? "" : ", " + count(settings.size(), "setting"))
        + ", "
        + count(faults.size(), "fault")
        + ", "
        + Quantities.durationText(endNs);
  }

  private static String count(int count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }
}
