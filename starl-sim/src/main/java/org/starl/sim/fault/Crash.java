package org.starl.sim.fault;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.sim.world.Unsynced;

/**
 * The program ends at once and, unless the crash is permanent, restarts when the fault ends. Robots
 * that are already down are skipped. {@code crash(bot2,at=12s,restart=5s,lose=unsynced)}.
 *
 * @param unsynced the effect on unflushed writes to stable storage
 */
public record Crash(RobotSelector who, Unsynced unsynced) implements FaultEffect {

  @Override
  public String name() {
    return "crash";
  }

  @Override
  public List<String> arguments() {
    return unsynced == Unsynced.LOST
        ? List.of(who.toString())
        : List.of(who.toString(), "lose=" + (unsynced == Unsynced.KEPT ? "nothing" : "some"));
  }

  @Override
  public String lastingKey() {
    return "restart";
  }

  @Override
  public Runnable begin(FaultContext onset) {
    for (RobotId robot : onset.whom()) {
      if (!onset.ward().isUp(robot)) {
        continue;
      }
      if (onset.lastingNs() == Span.NEVER) {
        onset.ward().crash(robot);
      } else {
        onset.ward().crash(robot, onset.lastingNs(), unsynced);
      }
    }
    return () -> {};
  }
}
