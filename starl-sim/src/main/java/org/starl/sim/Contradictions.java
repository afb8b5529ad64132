package org.starl.sim;

import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;

/** Settings that contradict each other: such a run would tell nothing. */
final class Contradictions {

  private final SimSettings settings;

  private Contradictions(SimSettings settings) {
    this.settings = settings;
  }

  /**
   * @param robots number of robots that start
   * @param endNs latest end of the run
   * @throws BadInput naming both keys and both values
   */
  static void check(SimSettings settings, Starts starts, int robots, long endNs) {
    Contradictions all = new Contradictions(settings);
    all.checkTypes(robots);
    all.checkMotion();
    all.checkStarts(starts);
    all.checkRadio();
    all.checkFaults(endNs);
  }

  private void checkTypes(int robots) {
    int discovery = settings.get(Setting.DISCOVERY_ROBOTS);
    int random = settings.get(Setting.RANDOM_ROBOTS);
    String types = "discoveryRobots=" + discovery + " and randomRobots=" + random + ": expected ";
    // Not the sum of ints, which may overflow.
    if ((long) discovery + random > robots) {
      throw new BadInput(types + "no more than robots=" + robots + " together");
    }
    if (discovery + random > 0 && settings.get(Setting.IDEAL_MOTION)) {
      throw new BadInput(types + "none with idealMotion=true, in which bodies do not bump");
    }
  }

  private void checkMotion() {
    double error = settings.get(Setting.SPEED_ERROR);
    if (error >= 1) {
      throw new BadInput("speedError=1: expected a fraction below 1");
    }
    if (error > 0 && settings.get(Setting.IDEAL_MOTION)) {
      throw new BadInput(
          "speedError=%s: expected 0 with idealMotion=true, in which wheels are exact"
              .formatted(Quantities.numberText(error)));
    }
    MotionParameters motion = settings.motionParameters(0);
    double speed = settings.get(Setting.MAX_SPEED);
    if (speed < motion.slowestMmPerS()) {
      throw new BadInput(
          "maxSpeed=%s: expected at least %s: a slower motion fails"
              .formatted(
                  Quantities.speedText(speed), Quantities.speedText(motion.slowestMmPerS())));
    }
    double noiseMm = settings.positionNoise().boundMm();
    if (noiseMm > motion.maxErrorMm()) {
      throw new BadInput(
          "positionNoise=%s: expected at most %s: with a larger error no robot moves"
              .formatted(
                  Quantities.distanceText(noiseMm), Quantities.distanceText(motion.maxErrorMm())));
    }
  }

  private void checkRadio() {
    if (settings.get(Setting.RADIO_SIGHT) && settings.get(Setting.RADIO_RANGE) == 0) {
      throw new BadInput("radioSight=true: expected a radioRange above 0, such as 3m");
    }
  }

  private void checkStarts(Starts starts) {
    double spacing = settings.get(Setting.START_SPACING);
    if (starts.areDrawn() && spacing < 2 && !settings.get(Setting.IDEAL_MOTION)) {
      throw new BadInput(
          "startSpacing=%s: expected at least 2 (robotRadius): bodies would overlap"
              .formatted(Quantities.numberText(spacing)));
    }
    String file = settings.get(Setting.START_FILE);
    if (!file.isEmpty() && starts.placed() == 0) {
      throw new BadInput(
          "startFile=%s: expected none: this app gives its robots' starts itself".formatted(file));
    }
  }

  private void checkFaults(long endNs) {
    if (endNs == Long.MAX_VALUE) {
      return;
    }
    String end = "duration=" + Quantities.durationText(endNs);
    for (Fault fault : settings.get(Setting.FAULTS).faults()) {
      long beginNs = fault.span().earliestNs();
      if (beginNs >= endNs) {
        throw new BadInput(
            "%s: begins at %s at the earliest: expected before the end, %s"
                .formatted(
                    BadInput.quote(fault.toString()), Quantities.durationText(beginNs), end));
      }
    }
    if (settings.get(Setting.CHAOS) != Envelope.NONE && settings.chaosEndNs() > endNs) {
      throw new BadInput(
          "chaosFor=%s: expected no more than %s: faults must end within the run"
              .formatted(Quantities.durationText(settings.chaosEndNs()), end));
    }
  }
}
