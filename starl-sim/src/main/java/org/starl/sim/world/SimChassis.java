package org.starl.sim.world;

import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.platform.Chassis;
import org.starl.platform.Strand;
import org.starl.random.Rng;

/**
 * A robot's wheels and bump sensors, in one incarnation of its program, on its {@link Body} while
 * the body is on the floor. Off the floor the wheels turn freely and no bump occurs.
 */
public final class SimChassis implements Chassis {

  private final Runnable reportBump;
  private final Rng rng;
  private final double speedError;
  private WheelCommand command = WheelCommand.STOP;
  private WheelCommand actual = WheelCommand.STOP;
  private double linearFactor = 1;
  private double angularFactor = 1;
  private Runnable receiver = () -> {};
  private @Nullable Body body;

  /**
   * @param strand the robot's strand, on which bumps are reported
   * @param rng the chassis's own generator
   * @param speedError forward and turning speed of each new command have independent factors,
   *     uniform from 1 - speedError to 1 + speedError; 0 for perfect wheels
   */
  public SimChassis(Strand strand, Rng rng, double speedError) {
    if (!(speedError >= 0 && speedError < 1)) {
      throw new IllegalArgumentException("speed error " + speedError + ": expected 0 to below 1");
    }
    this.rng = rng;
    this.speedError = speedError;
    Runnable toReceiver = () -> receiver.run();
    reportBump = () -> strand.post(toReceiver);
  }

  /** Puts the body on the floor: it follows the last command. */
  public void mount(Body newBody) {
    body = newBody;
    newBody.onBump(reportBump);
    apply();
  }

  /** Takes the body off the floor. */
  public void unmount() {
    body = null;
  }

  /** Ends the program: the wheels stop and ignore later commands of the program. */
  public void halt() {
    if (body != null) {
      body.drive(WheelCommand.STOP);
      body = null;
    }
  }

  @Override
  public void drive(WheelCommand newCommand) {
    if (newCommand.equals(command)) {
      return;
    }
    command = newCommand;
    actual =
        speedError == 0
            ? command
            : new WheelCommand(
                command.linearMmPerS() * drawFactor(), command.angularRadPerS() * drawFactor());
    apply();
  }

  @Override
  public Bumps bumps() {
    return body == null ? Bumps.NONE : body.bumps();
  }

  @Override
  public void onBump(Runnable newReceiver) {
    receiver = newReceiver;
  }

  /**
   * Sets the wheel speeds as fractions of the commanded speeds: 0 and 0 for stuck wheels, 1 and 1
   * for intact wheels.
   */
  public void impair(double newLinearFactor, double newAngularFactor) {
    linearFactor = newLinearFactor;
    angularFactor = newAngularFactor;
    apply();
  }

  private void apply() {
    if (body != null) {
      body.drive(
          linearFactor == 1 && angularFactor == 1
              ? actual
              : new WheelCommand(
                  actual.linearMmPerS() * linearFactor, actual.angularRadPerS() * angularFactor));
    }
  }

  private double drawFactor() {
    return 1 + speedError * (2 * rng.nextDouble() - 1);
  }
}
