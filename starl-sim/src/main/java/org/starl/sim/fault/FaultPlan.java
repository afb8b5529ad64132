package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * The faults of a run. Its text is a list separated by {@code ;}, as in the setting {@code faults};
 * commas are accepted too, as in a list of a scenario file.
 */
public record FaultPlan(List<Fault> faults) {

  public static final FaultPlan NONE = new FaultPlan(List.of());

  public FaultPlan {
    faults = List.copyOf(faults);
  }

  /** @throws org.starl.input.BadInput if a text is not a fault */
  public static FaultPlan parse(String text) {
    List<Fault> faults = new ArrayList<>();
    int depth = 0;
    int begin = 0;
    for (int i = 0; i <= text.length(); i++) {
      char c = i == text.length() ? ';' : text.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      boolean isEnd = i == text.length() || c == ';' || (c == ',' && depth <= 0);
      if (isEnd) {
        String part = text.substring(begin, i);
        if (!part.isBlank()) {
          faults.add(FaultGrammar.parse(part));
        }
        begin = i + 1;
        depth = 0;
      }
    }
    return new FaultPlan(faults);
  }

  /**
   * Draws a plan from an envelope: faults begin and end, alone and together, and all have ended by
   * {@code untilNs}, except permanent crashes of {@link Envelope#MORTAL}. After that time
   * primitives must make progress.
   *
   * @param isSealed whether datagrams are sealed: then an attacker without the key is among the
   *     faults
   * @param robots the deployment, of which a majority stays up
   * @param timeoutNs the longest timeout of the protocols: most plans with enough time have outages
   *     that last longer; 0 for no outages
   */
  public static FaultPlan chaos(
      Envelope envelope, boolean isSealed, int robots, long timeoutNs, long untilNs, Rng rng) {
    return Chaos.draw(envelope, isSealed, robots, timeoutNs, untilNs, rng);
  }

  /** These faults, then those of {@code other}. */
  public FaultPlan plus(FaultPlan other) {
    List<Fault> all = new ArrayList<>(faults);
    all.addAll(other.faults);
    return new FaultPlan(all);
  }

  public boolean isEmpty() {
    return faults.isEmpty();
  }

  /**
   * @throws BadInput if a fault names an unknown robot
   */
  public void requireNamedAmong(Collection<RobotId> robots) {
    for (Fault fault : faults) {
      for (RobotSelector selector : fault.effect().named()) {
        for (RobotId robot : selector.named()) {
          if (!robots.contains(robot)) {
            throw new BadInput(
                BadInput.quote(fault.toString())
                    + ": "
                    + RobotSelector.unknownRobotMessage(robot, robots));
          }
        }
      }
    }
  }

  /** Whether a robot may crash without a restart. */
  public boolean mayLeaveDown() {
    return faults.stream().anyMatch(fault -> fault.effect().isCrash() && !fault.span().isFinite());
  }

  /** Whether a fault changes a robot's time, so that robots need their own clocks. */
  public boolean changesTime() {
    return faults.stream().anyMatch(fault -> fault.effect().changesTime());
  }

  /**
   * Starts the faults of a run; faults at time 0 begin now.
   *
   * @param rng generator of the run's seed, forked for faults
   * @return the object that adds more faults
   */
  public FaultRun install(FaultTarget target, Rng rng) {
    FaultRun run = new FaultRun(target);
    run.add(this, rng);
    return run;
  }

  @Override
  public String toString() {
    return faults.stream().map(Fault::toString).collect(Collectors.joining("; "));
  }
}
