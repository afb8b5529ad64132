package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * The faults of a run. Its text is its faults with {@code ;} between them, as in the setting {@code
 * faults}; commas are read as well, as in a list of a scenario file.
 */
public record FaultPlan(List<Fault> faults) {

  public static final FaultPlan NONE = new FaultPlan(List.of());

  public FaultPlan {
    faults = List.copyOf(faults);
  }

  /** @throws org.starl.input.BadInput if one of them is not a fault */
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
   * A plan drawn from an envelope: faults that come and go, alone and together, and have all ended
   * by {@code untilNs}, except that with {@link Envelope#MORTAL} some robots stay dead. After that
   * time progress can be demanded.
   *
   * @param robots of the deployment, of which a majority stays alive
   */
  public static FaultPlan chaos(Envelope envelope, int robots, long untilNs, Rng rng) {
    return Chaos.draw(envelope, robots, untilNs, rng);
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
   * @throws BadInput if a fault names another robot
   */
  public void requireNamedAmong(Collection<RobotId> robots) {
    for (Fault fault : faults) {
      for (RobotSelector who : fault.effect().named()) {
        for (RobotId robot : who.named()) {
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

  /** Whether it changes some robot's time, so that robots need clocks of their own. */
  public boolean touchesTime() {
    return faults.stream()
        .anyMatch(fault -> fault.effect() instanceof RobotFault harm && harm.touchesTime());
  }

  /**
   * Starts the faults of a run: those that begin with the run begin now.
   *
   * @param rng of the run's seed, forked for faults
   * @return for adding more faults
   */
  public FaultRun install(FaultTarget ward, Rng rng) {
    FaultRun run = new FaultRun(ward);
    run.add(this, rng);
    return run;
  }

  @Override
  public String toString() {
    return faults.stream().map(Fault::toString).collect(Collectors.joining("; "));
  }
}
