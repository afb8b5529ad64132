package org.starl.sim.world;

import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.platform.Chassis;
import org.starl.platform.Strand;
import org.starl.random.Rng;
import org.starl.sim.kernel.Kernel;

/**
 * A robot's wheels and bump sensors, in one incarnation of its program, on its {@link Body} while
 * the body is on the floor. Off the floor the wheels turn freely and no bump occurs.
 */
public final class SimChassis implements Chassis {

  private final Runnable reportBump;
  private final Rng rng;
  private final double speedError;
  // Null if each command takes effect at once.
  private final @Nullable Kernel kernel;
  private final long reactionNs;
  private long inEffectNs;
  private WheelCommand command = WheelCommand.STOP;
  private WheelCommand actual = WheelCommand.STOP;
  private double linearFactor = 1;
  private double angularFactor = 1;
  private Runnable receiver = () -> {};
  private @Nullable Body body;

  /**
   * Wheels that take up each command at once.
   *
   * @param strand the robot's strand, on which bumps are reported
   * @param rng the chassis's own generator
   * @param speedError forward and turning speed of each new command have independent factors from 1 -
   *     speedError to 1 + speedError, half of them at these bounds; 0 for perfect wheels
   */
  public SimChassis(Strand strand, Rng rng, double speedError) {
    this(strand, rng, speedError, null, 0);
  }

  /**
   * Wheels that take up each command after a time of its own, in the order of the commands: after
   * the longest time in half of the cases.
   *
   * @param reactionNs the longest time, in ns
   */
  public SimChassis(
      Strand strand, Rng rng, double speedError, @Nullable Kernel kernel, long reactionNs) {
    if (!(speedError >= 0 && speedError < 1)) {
      throw new IllegalArgumentException("speed error " + speedError + ": expected 0 to below 1");
    }
    this.rng = rng;
    this.speedError = speedError;
    this.kernel = reactionNs == 0 ? null : kernel;
    this.reactionNs = reactionNs;
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
    WheelCommand next =
        speedError == 0
            ? command
            : new WheelCommand(
                command.linearMmPerS() * drawFactor(), command.angularRadPerS() * drawFactor());
    if (kernel == null) {
      turn(next);
    } else {
      long lateNs = rng.nextBoolean(0.5) ? reactionNs : rng.nextLong(0, reactionNs);
      inEffectNs = Math.max(inEffectNs, kernel.nowNs() + lateNs);
      kernel.schedule(inEffectNs, () -> turn(next));
    }
  }

  private void turn(WheelCommand next) {
    actual = next;
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
    return 1 + speedError * Math.clamp(4 * rng.nextDouble() - 2, -1, 1);
  }
}
