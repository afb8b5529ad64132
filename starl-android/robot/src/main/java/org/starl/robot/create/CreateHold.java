package org.starl.robot.create;

import java.util.List;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.Var;

/** Reasons for which the driver stops the wheels; {@link #CLIFF} and {@link #BUMP} only limit them. */
public enum CreateHold {
  /** {@link CreateChassis#emergencyStop} was called and not released. */
  EMERGENCY_STOP,
  /** There is no link to the robot, which continues its last command. */
  NO_LINK,
  /** The link is open, but no sensor frames arrive. */
  NO_SENSORS,
  /** The robot is not in the mode of the settings. */
  NOT_IN_MODE,
  /** A wheel hangs down. */
  WHEEL_DROP,
  /** A bump sensor has closed, and the program has not been informed yet. */
  BUMP_UNTOLD,
  /** The program has not repeated its command for too long. */
  STALE_COMMAND,
  /** The last fix is too old, or there is none. */
  STALE_POSITION,
  /** A cliff is seen: only straight backward is allowed. */
  CLIFF,
  /** A bump sensor is closed: turning and backward are allowed, forward is not. */
  BUMP;

  /** The source of {@link #HELD_BY} in traces. */
  public static final Instance WHEELS = Instance.of("wheels");

  /** What stops or limits the wheels now, below the program: worst first. */
  public static final Var<List<CreateHold>> HELD_BY =
      Var.of("heldBy", Shapes.list(Shapes.constant(CreateHold.class), values().length));

  /** Whether it stops the wheels completely. */
  public boolean isWhole() {
    return this != CLIFF && this != BUMP;
  }
}
