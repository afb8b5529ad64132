package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.world.PositionNoise;

/** Impairs a part of a robot; its program continues. */
public sealed interface RobotFault extends FaultEffect {

  /** The impairment. */
  Impairment impairment(Rng rng);

  /** Whether the fault changes the robot's time, so that the robot needs its own clock. */
  default boolean touchesTime() {
    return false;
  }

  @Override
  default Runnable begin(FaultContext onset) {
    Impairment impairment = impairment(onset.rng());
    if (who().isAll()) {
      return onset.ward().impair(null, impairment);
    }
    List<Runnable> cures = new ArrayList<>();
    for (RobotId robot : onset.whom()) {
      cures.add(onset.ward().impair(robot, impairment));
    }
    return () -> cures.forEach(Runnable::run);
  }

  /** The wheels do not turn: {@code stuck(bot1)}. */
  record Stuck(RobotSelector who) implements RobotFault {
    @Override
    public String name() {
      return "stuck";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString());
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofWheels(0);
    }
  }

  /** The wheels turn at this fraction of the commanded speed: {@code slow(bot1,0.5)}. */
  record Slow(RobotSelector who, double fraction) implements RobotFault {
    @Override
    public String name() {
      return "slow";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString(), Quantities.numberText(fraction));
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofWheels(fraction);
    }
  }

  /**
   * Fixes have larger errors and report the larger bound: {@code noise(bot1,30mm)}, {@code
   * noise(all,30mm,0.1rad)}.
   */
  record Noise(RobotSelector who, PositionNoise more) implements RobotFault {
    @Override
    public String name() {
      return "noise";
    }

    @Override
    public List<String> arguments() {
      String mm = Quantities.distanceText(more.boundMm());
      return more.boundRad() == 0
          ? List.of(who.toString(), mm)
          : List.of(who.toString(), mm, Quantities.angleText(more.boundRad()));
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofPositioning(more, false, 0, 0);
    }
  }

  /** The robot gets no fixes: {@code dropout(bot1,at=5s,for=2s)}. */
  record Dropout(RobotSelector who) implements RobotFault {
    @Override
    public String name() {
      return "dropout";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString());
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofPositioning(PositionNoise.NONE, true, 0, 0);
    }
  }

  /** Fixes are shifted by this distance in a random direction; their bound does not change. */
  record Jump(RobotSelector who, double distanceMm) implements RobotFault {
    @Override
    public String name() {
      return "jump";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString(), Quantities.distanceText(distanceMm));
    }

    @Override
    public Impairment impairment(Rng rng) {
      double direction = 2 * StrictMath.PI * rng.nextDouble();
      return Impairment.ofPositioning(
          PositionNoise.NONE,
          false,
          distanceMm * StrictMath.cos(direction),
          distanceMm * StrictMath.sin(direction));
    }
  }

  /**
   * Each action of the robot takes this time, and later actions wait: {@code compute(bot1,20ms)}.
   */
  record Compute(RobotSelector who, long actionNs) implements RobotFault {
    @Override
    public String name() {
      return "compute";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString(), Quantities.durationText(actionNs));
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofTime(0, 0, actionNs);
    }

    @Override
    public boolean touchesTime() {
      return true;
    }
  }

  /** The clock is too fast by this rate, or too slow if negative: {@code drift(bot1,200ppm)}. */
  record Drift(RobotSelector who, long ppm) implements RobotFault {

    /** Maximum drift: half of the true rate. */
    static final long MOST_PPM = 500_000;

    @Override
    public String name() {
      return "drift";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString(), ppm + "ppm");
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofTime(ppm, 0, 0);
    }

    @Override
    public boolean touchesTime() {
      return true;
    }
  }

  /** The clock is ahead by this time, or behind if negative: {@code skew(bot1,50ms)}. */
  record Skew(RobotSelector who, long skewNs) implements RobotFault {
    @Override
    public String name() {
      return "skew";
    }

    @Override
    public List<String> arguments() {
      String text = Quantities.durationText(Math.abs(skewNs));
      return List.of(who.toString(), skewNs < 0 ? "-" + text : text);
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofTime(0, skewNs, 0);
    }

    @Override
    public boolean touchesTime() {
      return true;
    }
  }

  /**
   * Writes to stable storage need this additional time to survive a crash: {@code disk(bot1,50ms)}.
   */
  record Disk(RobotSelector who, long delayNs) implements RobotFault {
    @Override
    public String name() {
      return "disk";
    }

    @Override
    public List<String> arguments() {
      return List.of(who.toString(), Quantities.durationText(delayNs));
    }

    @Override
    public Impairment impairment(Rng rng) {
      return Impairment.ofDisk(delayNs);
    }
  }
}
