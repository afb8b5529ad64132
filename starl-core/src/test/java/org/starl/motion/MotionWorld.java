package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.random.Rng;

/**
 * One body, its wheels, its fixes and its motion, without any port: the simulation in which the
 * contract of motion is tested. The true error of a fix is uniform in the disc that its bound states, or on its border.
 */
final class MotionWorld {

  /** The body's path is looked at this often. */
  private static final long GRAIN_NS = 5 * NS_PER_MS;

  final MotionParameters parameters;
  final PositionFilter filter = new PositionFilter();

  /** Settings, before or during a run. */
  double noiseMm;

  double noiseRad;

  /** A fix states this part of its true error bound: below 1 the bound is wrong. */
  double honesty = 1;

  long fixPeriodMs = 75;
  long fixDelayMs;
  boolean fixesCome = true;

  /** The probabilities that a fix does not come, and that it is far off. */
  double dropouts;

  double jumps;

  /** The body does this part of what is commanded: 0 for stuck wheels. */
  double mobility = 1;

  /** Other faults of the wheels; set before the first motion. */
  double heldUp;

  double speedError;
  long reactionMs;

  /** Steps come late by up to this. */
  long stepLateMs;

  /** No part of the body gets past x = wallMm; the bump sensors tell of it if they work. */
  double wallMm = Double.POSITIVE_INFINITY;

  boolean bumpSensorsWork = true;

  /** The true pose. */
  Pose truth;

  long nowNs;
  WheelCommand command = WheelCommand.STOP;
  double nearestToAvoidMm = Double.POSITIVE_INFINITY;
  double worstErrorPastBoundMm = Double.NEGATIVE_INFINITY;

  /** The bound that stood beside the position of the latest step. */
  double errorBoundMm = Double.POSITIVE_INFINITY;

  /** To be avoided while it backs off. */
  Supplier<Region> retreatAvoid = Nowhere::new;

  private final Rng rng;
  private final TreeMap<Long, Pose> past = new TreeMap<>();
  private @Nullable Wheels wheels;
  private Region avoid = new Nowhere();
  private Bumps bumps = Bumps.NONE;
  private MotionRun run;
  private long nextFixNs;
  private long nextStepNs;
  private long lateNs;

  MotionWorld(long seed, MotionParameters parameters, Pose start) {
    this.rng = new Rng(seed);
    this.parameters = parameters;
    this.truth = start;
    filter.assume(parameters.speedError(), parameters.reactionMs() * NS_PER_MS);
    past.put(0L, start);
    run = MotionRun.turnTo(start.at(), retreatAvoid, parameters, rng.fork("moat"), 0);
  }

  MotionRun run() {
    return run;
  }

  double seconds() {
    return nowNs / 1e9;
  }

  /** Drives to the target until it is done or failed, or until {@code timeoutMs} have passed. */
  MotionFlag goTo(Point target, Region region, long timeoutMs) {
    begin(target, region);
    return runFor(timeoutMs);
  }

  void begin(Point target, Region region) {
    avoid = region;
    nearestToAvoidMm = avoid.distanceMm(truth.at());
    run = MotionRun.goTo(target, region, retreatAvoid, parameters, rng.fork("moat"), nowNs);
    nextStepNs = nowNs;
    lateNs = 0;
  }

  MotionFlag runFor(long timeoutMs) {
    long endNs = nowNs + timeoutMs * NS_PER_MS;
    while (nowNs < endNs && run.status() == MotionFlag.MOVING) {
      tick();
    }
    return run.status();
  }

  /** Goes on, whatever the motion's flag is. */
  void idle(long ms) {
    long endNs = nowNs + ms * NS_PER_MS;
    while (nowNs < endNs) {
      tick();
    }
  }

  /** Until the next fix or step, whichever is first. */
  void tick() {
    long untilNs = Math.min(nextFixNs, nextStepNs + lateNs);
    advance(untilNs);
    if (nextFixNs == untilNs) {
      if (fixesCome && !rng.nextBoolean(dropouts)) {
        fix();
      }
      nextFixNs += fixPeriodMs * NS_PER_MS;
    }
    if (nextStepNs + lateNs == untilNs) {
      step();
      nextStepNs += parameters.automatonPeriodMs() * NS_PER_MS;
      lateNs = stepLateMs == 0 ? 0 : rng.nextLong(0, stepLateMs * NS_PER_MS);
    }
  }

  private Wheels wheels() {
    if (wheels == null) {
      wheels = new Wheels(speedError, reactionMs * NS_PER_MS, rng.fork("wheels"));
      wheels.heldUp = heldUp;
    }
    wheels.mobility = mobility;
    return wheels;
  }

  private void step() {
    Location.Known known = filter.at(nowNs);
    if (known != null) {
      double error = known.pose().distanceMm(truth.at());
      errorBoundMm = known.errorMm();
      worstErrorPastBoundMm = Math.max(worstErrorPastBoundMm, error - known.errorMm());
    }
    WheelCommand next =
        run.step(
            known == null ? new Location.Unknown() : known,
            filter.isContradicted(),
            bumps,
            filter.lingering(nowNs),
            nowNs);
    if (!next.equals(command)) {
      command = next;
      filter.commanded(next, bumps.any(), nowNs);
      wheels().command(next, nowNs);
    }
  }

  private void fix() {
    long agoNs = Math.min(fixDelayMs * NS_PER_MS, nowNs);
    Pose then = past.ceilingEntry(nowNs - agoNs).getValue();
    double angle = 2 * StrictMath.PI * rng.nextDouble();
    double radius = noiseMm * (rng.nextBoolean(0.2) ? 1 : StrictMath.sqrt(rng.nextDouble()));
    // No other fix can contradict the first one, so it is correct.
    radius += filter.hasFix() && rng.nextBoolean(jumps) ? 1500 + 3000 * rng.nextDouble() : 0;
    Pose measured =
        new Pose(
            then.xMm() + radius * StrictMath.cos(angle),
            then.yMm() + radius * StrictMath.sin(angle),
            then.headingRad() + noiseRad * (2 * rng.nextDouble() - 1));
    filter.fixed(new Fix(measured, nowNs - agoNs, honesty * noiseMm, honesty * noiseRad), nowNs);
  }

  private void advance(long toNs) {
    while (nowNs < toNs) {
      long nextNs = Math.min(nowNs + GRAIN_NS - nowNs % GRAIN_NS, toNs);
      moveUntil(nextNs);
      nowNs = nextNs;
      past.put(nowNs, truth);
      past.headMap(nowNs - 1_000 * NS_PER_MS).clear();
      nearestToAvoidMm = Math.min(nearestToAvoidMm, avoid.distanceMm(truth.at()));
    }
  }

  private void moveUntil(long nextNs) {
    Pose free = wheels().drive(truth, nowNs, nextNs);
    boolean blocked = free.xMm() + parameters.robotRadiusMm() > wallMm && free.xMm() > truth.xMm();
    Bumps felt = blocked && bumpSensorsWork ? Bumps.BOTH : Bumps.NONE;
    if (felt != bumps) {
      bumps = felt;
      filter.commanded(command, bumps.any(), nowNs);
      step();
    } else if (blocked) {
      // A body with a closed bump sensor may slide along the object.
      double yMm = bumpSensorsWork ? free.yMm() : truth.yMm();
      truth = new Pose(truth.xMm(), yMm, free.headingRad());
    } else {
      truth = free;
    }
  }
}
