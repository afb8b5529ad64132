package org.starl.robot;

import java.io.IOException;
import java.util.function.Consumer;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateChassis;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.CreateSettings;
import org.starl.robot.create.CreateStatus;
import org.starl.robot.create.OiMode;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;

/** An iRobot Create as a deployment file describes it. */
public final class CreateWheelbase implements Wheelbase {

  private final CreateChassis chassis;

  private CreateWheelbase(CreateChassis chassis) {
    this.chassis = chassis;
  }

  /**
   * Opens Creates.
   *
   * @param name of the robot
   * @param links lead to it, however its bytes travel here
   */
  public static Source of(String name, Wheels.Create create, Limits limits, ByteLink.Source links) {
    CreateSettings settings = settings(create, limits);
    return (strand, clock, log, onFailure) ->
        new CreateWheelbase(
            CreateChassis.open(
                name, settings, links, strand, clock, new Teller(clock, log, onFailure)));
  }

  /** The model that a deployment file names. */
  public static CreateModel model(Wheels.Create create) {
    return create.model().equals("create1") ? CreateModel.CREATE_1 : CreateModel.CREATE_2;
  }

  private static CreateSettings settings(Wheels.Create create, Limits limits) {
    CreateSettings usual = CreateSettings.of(model(create));
    return new CreateSettings(
        usual.model(),
        OiMode.SAFE,
        limits.watchdogMs(),
        limits.positionMs(),
        usual.sensorTimeoutMs(),
        usual.recoverAfterMs(),
        usual.linkTimeoutMs(),
        usual.retryMs(),
        (int) limits.speedMmPerS());
  }

  @Override
  public Chassis chassis() {
    return chassis;
  }

  @Override
  public void fixed(Fix fix) {
    chassis.fixed(fix);
  }

  @Override
  public void emergencyStop() {
    chassis.emergencyStop();
  }

  @Override
  public void release() {
    chassis.release();
  }

  @Override
  public String status() {
    CreateStatus status = chassis.status();
    return status.mayDrive() ? "may drive" : "held by " + status.holds();
  }

  @Override
  public void close() {
    chassis.close();
  }

  /** Logs the robot's state. */
  private static final class Teller implements CreateChassis.Listener {
    private static final String TAG = "create";

    private final Clock clock;
    private final LogSink log;
    private final Consumer<Throwable> onFailure;

    // The thread that opens links only.
    private String lastFailure = "";

    Teller(Clock clock, LogSink log, Consumer<Throwable> onFailure) {
      this.clock = clock;
      this.log = log;
      this.onFailure = onFailure;
    }

    @Override
    public void changed(CreateStatus status) {
      log.log(clock.nowNs(), Level.DEBUG, TAG, "held by " + status.holds());
    }

    @Override
    public void linkFailed(IOException cause) {
      // Links are retried again and again: a repeated cause is logged once.
      String failure = String.valueOf(cause.getMessage());
      if (!failure.equals(lastFailure)) {
        lastFailure = failure;
        log.log(clock.nowNs(), Level.WARN, TAG, "no link to the robot: " + failure);
      }
    }

    @Override
    public void failed(Throwable bug) {
      onFailure.accept(bug);
      log.log(clock.nowNs(), Level.ERROR, TAG, "the driver has failed, wheels stopped: " + bug);
    }
  }
}
