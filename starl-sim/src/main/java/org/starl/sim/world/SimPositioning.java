package org.starl.sim.world;

import java.util.SortedMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Positioning;
import org.starl.platform.StartNeeds;
import org.starl.platform.Timer;
import org.starl.platform.Timers;
import org.starl.random.Rng;

/**
 * Measures the pose of a robot's {@link Body} once per period, in one incarnation of its program,
 * while the body is on the floor. The measuring system is external: its period is in true time,
 * independent of the robot's clock. Fixes are taken at phase + k * period since the start of the
 * run, so that a restart does not change their times.
 */
public final class SimPositioning implements Positioning {

  // Slightly less than 1, so that rounding of large coordinates does not exceed the bound.
  private static final double INSIDE = 1 - 1e-6;

  private final Clock trueClock;
  private final Clock robotClock;
  private final Rng rng;
  private final long periodNs;
  private final long phaseNs;
  private final Timer timer;
  private PositionNoise noise;
  private PositionNoise offset = PositionNoise.NONE;
  private double offXMm;
  private double offYMm;
  private boolean isOn = true;
  private final MeasuredRobots measured;
  private final MeasuredRobots.Newest own;
  private Consumer<StartNeeds> needsListener = needs -> {};
  private Runnable beforeFix = () -> {};
  private Runnable afterFix = () -> {};
  private @Nullable Receiver receiver;
  private boolean hasMeasured;
  private @Nullable Body body;

  /**
   * @param self the robot that it measures
   * @param measured the fixes of all robots of the measuring system
   * @param trueClock the run's true time
   * @param robotClock the robot's clock, which stamps the fixes
   * @param strandTimers the robot's strand, in true time
   * @param rng the robot's generator for positioning
   * @param phaseNs at least 0 and less than the period; see {@link #drawnPhaseNs}. With equal
   *     phases all robots are measured at once
   */
  public SimPositioning(
      RobotId self,
      MeasuredRobots measured,
      Clock trueClock,
      Clock robotClock,
      Timers strandTimers,
      Rng rng,
      PositionNoise noise,
      long periodNs,
      long phaseNs) {
    if (periodNs <= 0 || phaseNs < 0 || phaseNs >= periodNs) {
      throw new IllegalArgumentException(
          "period " + periodNs + " ns, phase " + phaseNs + " ns: expected 0 <= phase < period");
    }
    this.measured = measured;
    this.own = measured.of(self);
    this.trueClock = trueClock;
    this.robotClock = robotClock;
    this.rng = rng;
    this.noise = noise;
    this.periodNs = periodNs;
    this.phaseNs = phaseNs;
    this.timer = strandTimers.timer(this::measure);
  }

  /**
   * Draws a phase for one robot, uniform over the period, since a real system measures its robots
   * in turn. Depends only on the seed of {@code rng}.
   */
  public static long drawnPhaseNs(Rng rng, long periodNs) {
    return rng.fork("phase").nextLong(0, periodNs - 1);
  }

  @Override
  public void onFix(Receiver newReceiver) {
    if (receiver != null) {
      throw new IllegalStateException("positioning has a receiver already");
    }
    receiver = newReceiver;
    begin();
  }

  @Override
  public SortedMap<RobotId, Fix> newest() {
    return measured.shownTo(robotClock, trueClock);
  }

  @Override
  public void require(StartNeeds needs) {
    needsListener.accept(needs);
  }

  /** Sets the receiver of what the robot's program needs; without it, needs are ignored. */
  public void onNeeds(Consumer<StartNeeds> listener) {
    needsListener = listener;
  }

  /** Sets what is called before and after the program receives a fix. */
  public void aroundFix(Runnable before, Runnable after) {
    beforeFix = before;
    afterFix = after;
  }

  /** Whether it has delivered a fix. */
  public boolean hasMeasured() {
    return hasMeasured;
  }

  /** Puts the body on the floor: fixes begin. */
  public void mount(Body newBody) {
    body = newBody;
    begin();
  }

  /** Takes the body off the floor: fixes end. */
  public void unmount() {
    body = null;
    timer.cancel();
  }

  private void begin() {
    if (receiver != null && body != null) {
      timer.set(nextNs(trueClock.nowNs()));
    }
  }

  /** Sets whether fixes are delivered; missed fixes are not delivered later. */
  public void turn(boolean on) {
    isOn = on;
  }

  /** Sets a further error of fixes, included in their bound: as large as that, in any direction. */
  public void setNoise(PositionNoise further) {
    offset = further;
  }

  /** Sets an additional error of fixes that their bound does not include. */
  public void setOffset(double newOffXMm, double newOffYMm) {
    offXMm = newOffXMm;
    offYMm = newOffYMm;
  }

  private void measure() {
    long nowNs = trueClock.nowNs();
    timer.set(nextNs(nowNs + 1));
    if (isOn && receiver != null && body != null) {
      hasMeasured = true;
      beforeFix.run();
      PositionNoise bound = noise.plus(offset);
      Pose pose = offset(drawn(body.pose()));
      Fix fix = new Fix(pose, nowNs, bound.boundMm(), bound.boundRad());
      own.fix = fix;
      receiver.fixed(
          robotClock == trueClock
              ? fix
              : new Fix(pose, robotClock.nowNs(), bound.boundMm(), bound.boundRad()));
      afterFix.run();
    }
  }

  private Pose drawn(Pose truth) {
    double offX = 0;
    double offY = 0;
    if (noise.boundMm() > 0) {
      do {
        offX = PositionNoise.drawWithinOne(rng);
        offY = PositionNoise.drawWithinOne(rng);
      } while (offX * offX + offY * offY > INSIDE);
    }
    double offRad = noise.boundRad() > 0 ? INSIDE * PositionNoise.drawWithinOne(rng) : 0;
    return new Pose(
        truth.xMm() + noise.boundMm() * offX + offXMm,
        truth.yMm() + noise.boundMm() * offY + offYMm,
        offRad == 0
            ? truth.headingRad()
            : Angles.normalize(truth.headingRad() + noise.boundRad() * offRad));
  }

  private Pose offset(Pose pose) {
    if (offset.equals(PositionNoise.NONE)) {
      return pose;
    }
    double inRad = 2 * StrictMath.PI * rng.nextDouble();
    double offRad = rng.nextBoolean(0.5) ? offset.boundRad() : -offset.boundRad();
    return Pose.of(
        pose.at()
            .plus(
                new Point(StrictMath.cos(inRad), StrictMath.sin(inRad))
                    .times(INSIDE * offset.boundMm())),
        Angles.normalize(pose.headingRad() + INSIDE * offRad));
  }

  /** The time of the first fix at or after {@code fromNs}. */
  private long nextNs(long fromNs) {
    long periods = Math.max(0, Math.ceilDiv(fromNs - phaseNs, periodNs));
    return phaseNs + periods * periodNs;
  }
}
