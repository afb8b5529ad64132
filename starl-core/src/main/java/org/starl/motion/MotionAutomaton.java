package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/**
 * One motion command, from its start to DONE or FAIL, as a state machine without ports: the result
 * of {@link #step} depends only on the arguments of all steps so far and on the generator. It
 * trusts the pose that it is given; {@link MotionRun} adds the safety checks.
 */
public sealed interface MotionAutomaton permits UnicycleAutomaton, IdealAutomaton {

  /**
   * Creates the automaton for going to {@code target}, in the style of {@code parameters}.
   *
   * @param mayWander whether a random mover may drive aside first
   */
  static MotionAutomaton goTo(
      Point target, boolean mayWander, MotionParameters parameters, Rng rng) {
    return switch (parameters.style()) {
      case UNICYCLE -> new UnicycleAutomaton(target, false, mayWander, parameters, rng);
      case IDEAL -> new IdealAutomaton(target, false, parameters);
    };
  }

  /** Creates the automaton for turning on the spot until the robot faces {@code target}. */
  static MotionAutomaton turnTo(Point target, MotionParameters parameters, Rng rng) {
    return switch (parameters.style()) {
      case UNICYCLE -> new UnicycleAutomaton(target, true, false, parameters, rng);
      case IDEAL -> new IdealAutomaton(target, true, parameters);
    };
  }

  /**
   * Computes the wheel command until the next step, which comes one period later or when the bump
   * sensors change.
   */
  WheelCommand step(Pose pose, Bumps bumps, long nowNs);

  /** MOVING, DONE or FAIL, after the last step. */
  MotionFlag status();

  MotionState state();

  /** Ends the manoeuvre of a robot that is not of type GOAL; returns whether there was one. */
  default boolean givesUpManeuver() {
    return false;
  }

  /** Whether it has bumped during this motion, and goes on although its policy is to stop. */
  default boolean goesOnAfterBump() {
    return false;
  }
}
