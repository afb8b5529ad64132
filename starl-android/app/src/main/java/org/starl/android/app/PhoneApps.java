package org.starl.android.app;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.hello.logic.Hello;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Trip;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;

/**
 * The apps that a phone can run, by name: the same classes as in the simulator. Scenarios drawn from
 * the seed need the simulator, which a phone does not have; so a phone runs only the scenarios that
 * are the same for every seed.
 */
final class PhoneApps {

  private static final String XID = "crossing";
  private static final String SCENARIO = "scenario";
  private static final String FIGURE7 = "figure7";

  /** Accepted and ignored: debris exists only on a simulated floor. */
  private static final String DEBRIS = "debris";

  /** Makes the app of one robot of a deployment. */
  private interface Maker {
    Function<GlobalVarHolder, LogicThread> make(Deployment deployment, RobotId robot);
  }

  private static final SortedMap<String, Maker> ALL = all();

  private PhoneApps() {}

  /** Their names. */
  static List<String> names() {
    return new ArrayList<>(ALL.keySet());
  }

  /**
   * Makes the app of {@code robot}.
   *
   * @throws BadInput if a phone has no such app, or not with these parameters
   */
  static Function<GlobalVarHolder, LogicThread> factory(Deployment deployment, RobotId robot) {
    Maker maker = ALL.get(deployment.app());
    if (maker == null) {
      throw deployment.error("app", deployment.app(), "one of " + names() + " on a phone");
    }
    return maker.make(deployment, robot);
  }

  private static SortedMap<String, Maker> all() {
    SortedMap<String, Maker> all = new TreeMap<>();
    all.put("hello", PhoneApps::hello);
    all.put("intersection", PhoneApps::intersection);
    return Collections.unmodifiableSortedMap(all);
  }

  private static Function<GlobalVarHolder, LogicThread> hello(
      Deployment deployment, RobotId robot) {
    refuseAllBut(deployment);
    return Hello::new;
  }

  /** Paper, section 3, with the cars of Figure 7: the first robot by name takes the first route. */
  private static Function<GlobalVarHolder, LogicThread> intersection(
      Deployment deployment, RobotId robot) {
    refuseAllBut(deployment, SCENARIO, DEBRIS);
    String scenario = deployment.parameters().get(SCENARIO);
    if (!FIGURE7.equals(scenario)) {
      throw deployment.error(SCENARIO, String.valueOf(scenario), FIGURE7 + " on a phone");
    }
    int number = deployment.participants().asList().indexOf(robot);
    if (number < 0 || number >= Route.FIGURE7.size()) {
      throw deployment.error(
          SCENARIO,
          FIGURE7,
          "at most " + Route.FIGURE7.size() + " robots; " + robot + " is one too many");
    }
    Trip trip = Crossing.trip(Route.FIGURE7.get(number), 0);
    return gvh -> new IntersectionApp(gvh, XID, trip, gvh.id.participants());
  }

  private static void refuseAllBut(Deployment deployment, String... known) {
    for (Map.Entry<String, String> parameter : deployment.parameters().entrySet()) {
      if (!Arrays.asList(known).contains(parameter.getKey())) {
        throw deployment.error(
            parameter.getKey(),
            parameter.getValue(),
            "one of " + Arrays.toString(known) + " for " + deployment.app() + " on a phone");
      }
    }
  }
}
