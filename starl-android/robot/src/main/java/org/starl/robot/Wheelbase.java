package org.starl.robot;

import java.io.IOException;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;

/**
 * Wheels with their safety functions below the program. All methods but {@link #chassis} may be
 * called from any thread.
 */
public interface Wheelbase extends AutoCloseable {

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

  /** The chassis that the program drives. */
  Chassis chassis();

  /** Takes each fix of this robot; without fixes the wheels stop. */
  void fixed(Fix fix);

  /** Stops the wheels at once, until {@link #release}. */
  void emergencyStop();

  /** Ends the emergency stop. */
  void release();

  /** The wheels' state, one line for people. */
  String status();

  /** Stops the wheels, then closes the link to them. */
  @Override
  void close();
}
