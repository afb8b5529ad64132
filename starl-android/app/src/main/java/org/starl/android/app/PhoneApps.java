package org.starl.android.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.robot.RealMotion;
import org.starl.robot.file.Deployment;

/** The apps of this APK, by name: the same classes as on a board and in the simulator. */
final class PhoneApps {

  private PhoneApps() {}

  /** Their names. */
  static List<String> names() {
    return new ArrayList<>(AppFactory.installed().keySet());
  }

  /**
   * The program of the deployment's robots.
   *
   * @throws BadInput if this APK has no such app, or not with these parameters
   */
  static RobotProgram program(Deployment deployment) {
    AppFactory factory = AppFactory.installed().get(deployment.app());
    if (factory == null) {
      throw deployment.error("app", deployment.app(), "one of " + names() + ", this phone's apps");
    }
    SortedMap<String, String> parameters = factory.defaults();
    for (Map.Entry<String, String> given : deployment.parameters().entrySet()) {
      if (parameters.replace(given.getKey(), given.getValue()) == null) {
        throw deployment.error(
            given.getKey(),
            given.getValue(),
            "one of " + parameters.keySet() + " for " + deployment.app() + " on a phone");
      }
    }
    try {
      Request request =
          new Request(
              deployment.seed(),
              OptionalInt.of(deployment.robots().size()),
              Parameter.values(factory.parameters(), parameters),
              parameters.keySet(),
              RealMotion.of(MotionParameters.DEFAULT, deployment.limits()));
      return factory.program(request);
    } catch (BadInput e) {
      String message = String.valueOf(e.getMessage());
      throw new BadInput(deployment.where(key(deployment, message)) + message);
    }
  }

  /** The parameter of the file that a message begins with. */
  private static String key(Deployment deployment, String message) {
    for (String key : deployment.parameters().keySet()) {
      if (message.startsWith(key + "=") || message.startsWith(key + ":")) {
        return key;
      }
    }
    return "app";
  }
}
