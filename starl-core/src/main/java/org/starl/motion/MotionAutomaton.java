package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/**
 * One motion command, from its start to DONE or FAIL, as a state machine that knows no port: what
 * {@link #step} returns depends on the arguments of all steps so far and on the generator alone. It
 * believes the pose that it is given; {@link MotionRun} is what doubts it.
 */
public sealed interface MotionAutomaton permits UnicycleAutomaton, IdealAutomaton {

  /** A command to go to {@code target}, in the style that {@code parameters} ask for. */
  static MotionAutomaton goTo(Point target, MotionParameters parameters, Rng rng) {
    return switch (parameters.style()) {
      case UNICYCLE -> new UnicycleAutomaton(target, false, parameters, rng);
      case IDEAL -> new IdealAutomaton(target, false, parameters);
    };
  }

  /** A command to turn on the spot until the robot faces {@code target}. */
  static MotionAutomaton turnTo(Point target, MotionParameters parameters, Rng rng) {
    return switch (parameters.style()) {
      case UNICYCLE -> new UnicycleAutomaton(target, true, parameters, rng);
      case IDEAL -> new IdealAutomaton(target, true, parameters);
    };
  }

  /**
   * What the wheels shall do until the next step, which comes a period later or as soon as the bump
   * sensors change.
   */
  WheelCommand step(Pose pose, Bumps bumps, long nowNs);

  /** MOVING, DONE or FAIL, as of the last step. */
  MotionFlag status();

  MotionState state();
}
