package org.starl.robot.create;

import java.io.IOException;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;

/**
 * Wheels with their safety functions below the program. The methods of {@link Chassis} belong to the
 * strand; all others may be called from any thread.
 */
public interface Wheelbase extends Chassis, AutoCloseable {

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

  /** Takes each fix of this robot; without fixes the wheels stop. */
  void fixed(Fix fix);

  /** Stops the wheels at once, until {@link #release}, whatever the program commands. */
  void emergencyStop();

  /** Ends the emergency stop: the program's next command is obeyed. */
  void release();

  /** Stops the wheels, then closes the link to them. */
  @Override
  void close();
}
