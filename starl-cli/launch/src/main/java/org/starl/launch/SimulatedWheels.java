package org.starl.launch;

import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.platform.Strand;
import org.starl.robot.create.Wheelbase;

/** Wheels of a body in the {@link WorldServer}, driven by its program in the same process. */
final class SimulatedWheels implements Wheelbase {

  private final WorldBody body;
  private final Strand strand;

  // Set by any thread; read on the world's strand, so that an earlier command cannot undo a stop.
  private volatile boolean isStopped;
  private volatile boolean isDoubted;
  private Runnable receiver = () -> {};

  SimulatedWheels(WorldBody body, Strand strand) {
    this.body = body;
    this.strand = strand;
    body.onBump(() -> strand.post(() -> receiver.run()));
  }

  @Override
  public void drive(WheelCommand command) {
    body.drive(() -> isStopped || isDoubted ? WheelCommand.STOP : command);
  }

  @Override
  public Bumps bumps() {
    return body.bumps();
  }

  @Override
  public void onBump(Runnable newReceiver) {
    receiver = newReceiver;
  }

  /** No watchdog is needed: wheels and program are in one process. */
  @Override
  public void fixed(Fix fix) {
    isDoubted = false;
  }

  @Override
  public void doubted() {
    isDoubted = true;
    body.drive(() -> WheelCommand.STOP);
  }

  @Override
  public void onTravel(TravelReceiver receiver) {
    body.onTravel(receiver);
  }

  @Override
  public void emergencyStop() {
    isStopped = true;
    body.drive(() -> WheelCommand.STOP);
  }

  @Override
  public void release() {
    isStopped = false;
  }

  @Override
  public void close() {
    emergencyStop();
  }

  @Override
  public String toString() {
    return strand + "'s simulated wheels";
  }
}
