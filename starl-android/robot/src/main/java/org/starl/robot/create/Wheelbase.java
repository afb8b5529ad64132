package org.starl.robot.create;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.Light;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;

/**
 * Wheels with their safety functions below the program. The methods of {@link Chassis} belong to the
 * strand; all others may be called from any thread.
 */
public interface Wheelbase extends Chassis, Light, AutoCloseable {

  /** A proximity sensor reports objects up to about this far beyond the body; not measured. */
  double NEAR_MM = 100;

  /** Opens the wheels of one robot. */
  @FunctionalInterface
  interface Source {
    /**
     * @param strand the robot's; bumps are reported there
     * @param clock the fixes' clock; may be read by any thread
     * @param onFailure takes a bug of the driver, from any thread; the wheels are already stopped for
     *     good
     * @throws IOException if they cannot be opened
     */
    Wheelbase open(Strand strand, Clock clock, LogSink log, Consumer<Throwable> onFailure)
        throws IOException;
  }

  /**
   * The bearings from the driving direction, counter-clockwise, of the proximity sensors that see an
   * object or a wall now; none unless overridden. Strand only.
   */
  default List<Double> nearRad() {
    return List.of();
  }

  /** {@inheritDoc} A drive without a light ignores it. */
  @Override
  default void show(int rgb) {}

  /** Takes each fix of this robot; without fixes the wheels stop. */
  void fixed(Fix fix);

  /** Fixes cannot be trusted: stops the wheels at once, until the next one. */
  void doubted();

  /**
   * Gives each state of the odometry to {@code receiver}, on any thread, which must not block; a drive
   * without odometry has none.
   */
  default void onTravel(TravelReceiver receiver) {}

  /**
   * Gives what holds the wheels, worst first, on the strand: now, and each time it has changed.
   */
  default void onHolds(Consumer<List<CreateHold>> receiver) {}

  /** Receives the odometry. */
  interface TravelReceiver {

    /**
     * @param mmPerS the commanded speed of the faster wheel
     * @param isTouched whether a contact may also move the body
     */
    void travelled(long atNs, CreateTravel travel, double mmPerS, boolean isTouched);

    /** From now on the body is off the floor, or on it again. */
    void lifted(boolean isLifted);

    /** Some way is missing before the next state. */
    void lost();
  }

  /** Stops the wheels at once, until {@link #release}, whatever the program commands. */
  void emergencyStop();

  /** Ends the emergency stop: the program's next command is obeyed. */
  void release();

  /** Stops the wheels, then closes the link to them. */
  @Override
  void close();
}
