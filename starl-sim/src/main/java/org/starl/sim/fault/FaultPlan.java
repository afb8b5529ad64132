package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * What goes wrong in a run. Its text is its faults with {@code ;} between them, as in the setting
 * {@code faults}; commas are read as well, as in a list of a scenario file.
 */
public record FaultPlan(List<Fault> faults) {

  public static final FaultPlan NONE = new FaultPlan(List.of());

  public FaultPlan {
    faults = List.copyOf(faults);
  }

  /** @throws org.starl.input.BadInput if one of them is no fault */
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
   * by {@code untilNs}; of {@link Envelope#MORTAL}, some robots stay dead. What comes after is a
   * world that behaves, in which progress can be demanded.
   *
   * @param robots of the deployment: a majority of so many stays alive
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
   * @throws BadInput if a fault names a robot that is none of these
   */
  public void requireNamedAmong(Collection<RobotId> robots) {
    for (Fault fault : faults) {
      for (Who who : fault.harm().named()) {
        for (RobotId robot : who.named()) {
          if (!robots.contains(robot)) {
            throw new BadInput(
                BadInput.quote(fault.toString()) + ": " + Who.isUnknown(robot, robots));
          }
        }
      }
    }
  }

  /** Whether some robot's time goes wrong, so that robots need clocks of their own. */
  public boolean touchesTime() {
    return faults.stream()
        .anyMatch(fault -> fault.harm() instanceof RobotHarm harm && harm.touchesTime());
  }

  /**
   * Lets them happen: those that begin with the run begin now.
   *
   * @param rng of the run's seed, forked for faults
   * @return takes more
   */
  public FaultRun install(Ward ward, Rng rng) {
    FaultRun run = new FaultRun(ward);
    run.add(this, rng);
    return run;
  }

  @Override
  public String toString() {
    return faults.stream().map(Fault::toString).collect(Collectors.joining("; "));
  }
}
