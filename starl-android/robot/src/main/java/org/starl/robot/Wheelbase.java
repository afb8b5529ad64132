package org.starl.robot;

import java.io.IOException;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;

/**
 * Wheels with what keeps them in check below the program. All but the {@link #chassis} may be called
 * from any thread.
 */
public interface Wheelbase extends AutoCloseable {

  /** Opens the wheels of one robot. */
  @FunctionalInterface
  interface Source {
    /**
     * @param strand the robot's; bumps are told there
     * @param clock the one by which fixes bear their times; may be read by any thread
     * @param onFailure is told, from any thread, of a bug below: the wheels stand already, for good
     * @throws IOException if there are none to be had
     */
    Wheelbase open(Strand strand, Clock clock, LogSink log, Consumer<Throwable> onFailure)
        throws IOException;
  }

  /** What the program drives. */
  Chassis chassis();

  /** There is a fix of this robot's; without them the wheels stop. */
  void fixed(Fix fix);

  /** Stops the wheels at once, until {@link #release}. */
  void emergencyStop();

  /** Takes the emergency stop back. */
  void release();

  /** How the wheels fare, in a line for people. */
  String status();

  /** Stops the wheels, then lets go of them. */
  @Override
  void close();
}
