package org.starl.android.app;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.starl.motion.Location;
import org.starl.robot.create.CreateHold;
import org.starl.robot.create.CreateSensors;
import org.starl.robot.create.CreateStatus;
import org.starl.robot.file.Deployment;

/** The activity's text about a robot and its phone, line by line. */
final class StatusText {

  private StatusText() {}

  /** This phone's robot. */
  static String identity(@Nullable Deployment deployment, String robot) {
    if (deployment == null) {
      return "no deployment: load one";
    }
    String app = deployment.app().isEmpty() ? "; choose the app" : ", app " + deployment.app();
    String others = deployment.robots().size() + " robots" + app;
    return robot.isEmpty() ? others + "; choose the robot of this phone" : robot + " of " + others;
  }

  /**
   * A robot's state.
   *
   * @param status null if there is no robot
   * @param phoneBatteryPercent below 0 if unknown
   */
  static List<String> lines(
      RobotService.Phase phase,
      String problem,
      @Nullable RobotStatus status,
      NetworkWatch.State network,
      int phoneBatteryPercent) {
    List<String> lines = new ArrayList<>();
    lines.add("Robot: " + phase.name().toLowerCase(Locale.ROOT) + after(problem));
    if (status != null) {
      lines.add("App: " + status.app() + " " + status.appState());
      lines.add("Position: " + position(status.location()));
      lines.add("Create: " + wheels(status));
      lines.add("Robot's battery: " + battery(status.wheels().sensors()));
      lines.add(
          String.format(
              "Radio: %s datagrams sent, %s received, %s dropped",
              status.radio().sent(),
              status.radio().received(),
              status.radio().dropped().values().stream().mapToLong(Long::longValue).sum()));
      lines.add(
          "Program: held its strand for "
              + status.strand().longestPieceNs() / NS_PER_MS
              + " ms at most");
    }
    lines.add("Network: " + network);
    lines.add(
        "Phone's battery: " + (phoneBatteryPercent < 0 ? "unknown" : phoneBatteryPercent + " %"));
    return lines;
  }

  static String position(@Nullable Location location) {
    if (!(location instanceof Location.Known known)) {
      return "unknown: no fix yet";
    }
    return known + ", fix " + known.fixAgeNs() / NS_PER_MS + " ms old";
  }

  private static String wheels(RobotStatus status) {
    CreateStatus wheels = status.wheels();
    if (wheels.holds().contains(CreateHold.NO_LINK)) {
      IOException problem = status.linkProblem();
      return "no link" + (problem == null ? "" : ": " + problem.getMessage());
    }
    String holds = wheels.holds().isEmpty() ? "may drive" : "held by " + wheels.holds();
    return holds + (wheels.linksLost() == 0 ? "" : "; link lost " + wheels.linksLost() + " times");
  }

  private static String battery(CreateSensors sensors) {
    return sensors.capacityMah() == 0
        ? "unknown"
        : 100 * sensors.chargeMah() / sensors.capacityMah() + " %, " + sensors.batteryMv() + " mV";
  }

  private static String after(String words) {
    return words.isEmpty() ? "" : ": " + words;
  }
}
