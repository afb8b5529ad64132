package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/** The impairments in effect, by robot. */
public final class Impairments {

  private final List<Impairment> ofAll = new ArrayList<>();
  private final Map<RobotId, List<Impairment>> ofOne = new LinkedHashMap<>();

  /**
   * @param robot null for all robots
   */
  public void add(@Nullable RobotId robot, Impairment impairment) {
    of(robot).add(impairment);
  }

  /** Removes an impairment that was added. */
  public void remove(@Nullable RobotId robot, Impairment impairment) {
    if (!of(robot).remove(impairment)) {
      throw new IllegalStateException(robot + " does not have " + impairment);
    }
  }

  /** The sum of the impairments of {@code robot}. */
  public Impairment total(RobotId robot) {
    Impairment total = Impairment.NONE;
    for (Impairment impairment : ofAll) {
      total = total.plus(impairment);
    }
    for (Impairment impairment : ofOne.getOrDefault(robot, List.of())) {
      total = total.plus(impairment);
    }
    return total;
  }

  private List<Impairment> of(@Nullable RobotId robot) {
    return robot == null ? ofAll : ofOne.computeIfAbsent(robot, id -> new ArrayList<>());
  }
}
