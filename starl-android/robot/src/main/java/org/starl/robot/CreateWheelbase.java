package org.starl.robot;

import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateChassis;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.CreateSettings;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;

/** iRobot Creates as a deployment file describes them. */
public final class CreateWheelbase {

  private CreateWheelbase() {}

  /**
   * Opens the Create of one robot. A link on which frames have stopped for {@link WheelGuard#SILENT_MS}
   * is opened again.
   *
   * @param name of the robot
   * @param links lead to the Create, each through a guard of its own
   */
  public static Wheelbase.Source of(
      String name, Wheels.Create create, Limits limits, ByteLink.Source links) {
    CreateSettings settings =
        CreateSettings.of(model(create))
            .withLimits(
                limits.watchdogMs(),
                limits.positionMs(),
                WheelGuard.SILENT_MS,
                Math.max(1, limits.reactionMs()),
                (int) limits.speedMmPerS());
    return (strand, clock, log, onFailure) ->
        CreateChassis.open(name, settings, links, strand, clock, log, onFailure);
  }

  /** The model that a deployment file names. */
  public static CreateModel model(Wheels.Create create) {
    return create.model().equals("create1") ? CreateModel.CREATE_1 : CreateModel.CREATE_2;
  }
}
