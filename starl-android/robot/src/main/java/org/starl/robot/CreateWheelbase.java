package org.starl.robot;

import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateChassis;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.CreateSettings;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;

/** iRobot Creates as a deployment file describes them. */
public final class CreateWheelbase {

  private CreateWheelbase() {}

  /**
   * Opens the Create of one robot.
   *
   * @param name of the robot
   * @param links lead to the Create
   */
  public static Wheelbase.Source of(
      String name, Wheels.Create create, Limits limits, ByteLink.Source links) {
    CreateSettings settings =
        CreateSettings.of(model(create))
            .withLimits(limits.watchdogMs(), limits.positionMs(), (int) limits.speedMmPerS());
    return (strand, clock, log, onFailure) ->
        CreateChassis.open(name, settings, links, strand, clock, log, onFailure);
  }

  /** The model that a deployment file names. */
  public static CreateModel model(Wheels.Create create) {
    return create.model().equals("create1") ? CreateModel.CREATE_1 : CreateModel.CREATE_2;
  }
}
