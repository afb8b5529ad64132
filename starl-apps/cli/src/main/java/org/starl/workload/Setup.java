package org.starl.workload;

import java.util.List;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.apps.Request;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** A run of a workload while its robots and monitors are added. */
final class Setup {

  /** Distance between the robots' starts: none is in another one's way. */
  static final double SPACING_MM = 3000;

  static final String ROUNDS = "rounds";
  static final String BUSY = "busy";
  static final int MAX_ROUNDS = 1000;

  private static final long NS_PER_MS = 1_000_000;
  private static final int DEFAULT_ROBOTS = 5;

  private final Request request;
  private final SimSettings settings;
  private final Course course;
  private final int robots;
  private final Simulation.Builder simulation;

  /**
   * @throws BadInput if the request has more robots than {@code maxRobots}, or a bad parameter
   */
  Setup(Request request, SimSettings settings, int maxRobots) {
    this.request = request;
    this.settings = settings;
    course = course(request);
    robots = request.robots().orElse(DEFAULT_ROBOTS);
    if (robots < 1 || robots > maxRobots) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + maxRobots);
    }
    simulation = Simulation.builder().settings(settings);
  }

  static Course course(Request request) {
    int rounds = whole(request, ROUNDS, 1, MAX_ROUNDS);
    try {
      return new Course(rounds, Quantities.durationNs(request.parameter(BUSY)) / NS_PER_MS);
    } catch (BadInput error) {
      throw Quantities.in(BUSY, error);
    }
  }

  Simulation.Builder simulation() {
    return simulation;
  }

  SimSettings settings() {
    return settings;
  }

  Course course() {
    return course;
  }

  int robots() {
    return robots;
  }

  /** The whole number that is the value of a parameter. */
  int whole(String key, int least, int most) {
    return whole(request, key, least, most);
  }

  /** The value of a parameter, one of {@code values}. */
  String choice(String key, List<String> values) {
    String value = request.parameter(key);
    if (!values.contains(value)) {
      throw new BadInput(
          key + "=" + BadInput.quote(value) + ": expected " + String.join(" or ", values));
    }
    return value;
  }

  /** The robots start on a square grid; this is the length of the floor's sides. */
  double sideMm() {
    return SPACING_MM * Math.ceil(Math.sqrt(robots));
  }

  /** Adds the robots. */
  void place(Function<GlobalVarHolder, ? extends Client> client) {
    int side = (int) Math.ceil(Math.sqrt(robots));
    for (int i = 0; i < robots; i++) {
      double xMm = SPACING_MM * (i % side + 0.5);
      int row = i / side;
      double yMm = SPACING_MM * (row + 0.5);
      RobotId id = new RobotId(settings.robotName() + i);
      simulation.robot(new RobotSpec(id, new Pose(xMm, yMm, 0), true, client));
    }
  }

  /** Time within which a primitive that needs a few rounds of messages has answered. */
  long withinNs() {
    return Bounds.withinNs(settings);
  }

  /** Registrations whose deadline is after {@link #withinNs}. */
  RegistrationSettings registration() {
    return RegistrationSettings.DEFAULT.withDeadlineMs(Bounds.deadlineMs(withinNs()));
  }

  private static int whole(Request request, String key, int least, int most) {
    try {
      return (int) Quantities.whole(request.parameter(key), least, most);
    } catch (BadInput error) {
      throw Quantities.in(key, error);
    }
  }
}
