package org.starl.motion;

import java.util.TreeMap;
import org.starl.geometry.Fix;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.random.Rng;

/**
 * One body with exact kinematics, its fixes and its motion, without any port: what the motion's
 * promises are tested in. The true error of a fix is uniform in the disc that its bound states.
 */
final class MotionWorld {

  static final long NS_PER_MS = 1_000_000;

  /** The body's path is looked at this often. */
  private static final long GRAIN_NS = 5 * NS_PER_MS;

  final MotionParameters parameters;
  final PositionFilter filter = new PositionFilter();

  /** What is set before or during a run. */
  double noiseMm;

  double noiseRad;
  long fixDelayMs;
  boolean fixesCome = true;

  /** The body does this part of what is commanded: 0 for stuck wheels. */
  double mobility = 1;

  /** No part of the body gets past x = wallMm; the bump sensors tell of it if they work. */
  double wallMm = Double.POSITIVE_INFINITY;

  boolean bumpSensorsWork = true;

  /** What is true. */
  Pose truth;

  long nowNs;
  WheelCommand command = WheelCommand.STOP;
  double nearestToAvoidMm = Double.POSITIVE_INFINITY;
  double worstErrorPastBoundMm = Double.NEGATIVE_INFINITY;

  /** The bound that stood beside the position of the latest step. */
  double errorBoundMm = Double.POSITIVE_INFINITY;

  private static final long FIX_PERIOD_MS = 75;

  private final Rng rng;
  private final TreeMap<Long, Pose> past = new TreeMap<>();
  private Region avoid = new Nowhere();
  private Bumps bumps = Bumps.NONE;
  private MotionRun run;
  private long nextFixNs;
  private long nextStepNs;

  MotionWorld(long seed, MotionParameters parameters, Pose start) {
    this.rng = new Rng(seed);
    this.parameters = parameters;
    this.truth = start;
    past.put(0L, start);
    run = MotionRun.turnTo(start.at(), avoid, parameters, rng.fork("moat"), 0);
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
    run = MotionRun.goTo(target, region, parameters, rng.fork("moat"), nowNs);
    nextStepNs = nowNs;
  }

  MotionFlag runFor(long timeoutMs) {
    long endNs = nowNs + timeoutMs * NS_PER_MS;
    while (nowNs < endNs && run.status() == MotionFlag.MOVING) {
      tick();
    }
    return run.status();
  }

  /** Until the next fix or step, whichever is first. */
  void tick() {
    long untilNs = Math.min(nextFixNs, nextStepNs);
    advance(untilNs);
    if (nextFixNs == untilNs) {
      if (fixesCome) {
        fix();
      }
      nextFixNs += FIX_PERIOD_MS * NS_PER_MS;
    }
    if (nextStepNs == untilNs) {
      step();
      nextStepNs += parameters.automatonPeriodMs() * NS_PER_MS;
    }
  }

  private void step() {
    Location.Known known = filter.at(nowNs);
    if (known != null) {
      double error = known.pose().distanceMm(truth.at());
      errorBoundMm = known.errorMm();
      worstErrorPastBoundMm = Math.max(worstErrorPastBoundMm, error - known.errorMm());
    }
    WheelCommand next = run.step(known == null ? new Location.Unknown() : known, bumps, nowNs);
    if (!next.equals(command)) {
      command = next;
      filter.commanded(next, bumps.any(), 0, nowNs);
    }
  }

  private void fix() {
    long agoNs = Math.min(fixDelayMs * NS_PER_MS, nowNs);
    Pose then = past.ceilingEntry(nowNs - agoNs).getValue();
    double angle = 2 * StrictMath.PI * rng.nextDouble();
    double radius = noiseMm * StrictMath.sqrt(rng.nextDouble());
    Pose measured =
        new Pose(
            then.xMm() + radius * StrictMath.cos(angle),
            then.yMm() + radius * StrictMath.sin(angle),
            then.headingRad() + noiseRad * (2 * rng.nextDouble() - 1));
    filter.fixed(new Fix(measured, nowNs - agoNs, noiseMm, noiseRad), nowNs);
  }

  private void advance(long toNs) {
    while (nowNs < toNs) {
      long nextNs = Math.min(nowNs + GRAIN_NS - nowNs % GRAIN_NS, toNs);
      moveFor((nextNs - nowNs) / 1e9);
      nowNs = nextNs;
      past.put(nowNs, truth);
      past.headMap(nowNs - 1_000 * NS_PER_MS).clear();
      nearestToAvoidMm = Math.min(nearestToAvoidMm, avoid.distanceMm(truth.at()));
    }
  }

  private void moveFor(double seconds) {
    double linear = command.linearMmPerS() * mobility;
    double angular = command.angularRadPerS() * mobility;
    Pose free = Kinematics.after(truth, linear, angular, seconds);
    boolean blocked = free.xMm() + parameters.robotRadiusMm() > wallMm && free.xMm() > truth.xMm();
    Bumps felt = blocked && bumpSensorsWork ? Bumps.BOTH : Bumps.NONE;
    truth = blocked ? new Pose(truth.xMm(), truth.yMm(), free.headingRad()) : free;
    if (felt != bumps) {
      bumps = felt;
      filter.commanded(command, bumps.any(), 0, nowNs);
    }
  }
}
