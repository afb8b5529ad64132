package org.starl.workload;

import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/**
 * A run of a workload while its robots and monitors are added.
 *
 * @param robots their number
 */
record Setup(
    Request request,
    SimSettings settings,
    Course course,
    int robots,
    Simulation.Builder simulation) {

  /** Distance between the robots' starts, so that no robot blocks another. */
  static final double SPACING_MM = 3000;

  private static final double WALL_MM = 1_200;

  /** Maximum time between two copies of a message that is repeated until answered. */
  private static final long RESEND_NS = 2 * Time.NS_PER_S;

  static final String SHORT = "short";

  static final Parameter PATIENCE =
      Parameter.choice(
          "patience",
          "whether a request is given up after all faults (long) or after 4 s (short)",
          "long",
          SHORT);

  private static final long SHORT_MS = 4_000;

  /** A probability so small that no campaign meets it. */
  private static final double NEVER = 1e-9;

  /** The robots start on a square grid; this is the length of the floor's sides. */
  double sideMm() {
    return SPACING_MM * Math.ceil(Math.sqrt(robots));
  }

  /** A wall on each corner between four robots, alternately horizontal and vertical. */
  Obstacles walls() {
    Obstacles walls = Obstacles.NONE;
    int corners = (int) (sideMm() / SPACING_MM) - 1;
    for (int i = 0; i < corners * corners; i++) {
      double xMm = (i % corners + 1) * SPACING_MM;
      Point at = new Point(xMm, (i / corners + 1) * SPACING_MM);
      Point half = i % 2 == 0 ? new Point(WALL_MM / 2, 0) : new Point(0, WALL_MM / 2);
      walls = walls.plus(Obstacle.wall(at.minus(half), at.plus(half)));
    }
    return walls;
  }

  /** Adds the robots, and what every workload requires of their datagrams. */
  void place(Function<GlobalVarHolder, ? extends Client> client) {
    simulation.monitor(WellFormedSpec::new);
    placeSilent(client);
  }

  /** Adds robots that send nothing. */
  void placeSilent(Function<GlobalVarHolder, ? extends Client> client) {
    int side = (int) Math.ceil(Math.sqrt(robots));
    for (int i = 0; i < robots; i++) {
      int row = i / side;
      Pose start = new Pose(SPACING_MM * (i % side + 0.5), SPACING_MM * (row + 0.5), 0);
      RobotId id = new RobotId(settings.robotName() + i);
      simulation.robot(new RobotSpec(id, start, true, client));
    }
  }

  /**
   * The paper's delta, in ns, for the network's loss and delay in the settings: the time within
   * which a message that is repeated until answered, and its answer, arrive. One copy may have been
   * lost just before the faults ended.
   */
  static long deltaNs(SimSettings settings) {
    double lossOfOne = settings.get(Setting.MESSAGE_LOSS);
    double loss = 1 - (1 - lossOfOne) * (1 - lossOfOne);
    if (loss >= 1) {
      return Long.MAX_VALUE / 1_000_000;
    }
    long copies = 1;
    if (loss > 0) {
      copies += (long) Math.ceil(StrictMath.log(NEVER) / StrictMath.log(loss));
    }
    return settings.messageDelay().longestNs() + copies * RESEND_NS;
  }

  /** The specification of the registration in which the robots take part. */
  RegistrationSpec registered(RegistrationSettings times) {
    RegistrationSpec spec = new RegistrationSpec(withinNs()).standingIn().patient(times);
    return isLossless() && !settings.hasFaults() ? spec.undisturbed() : spec;
  }

  /** Whether the network loses nothing without faults. */
  boolean isLossless() {
    return settings.get(Setting.MESSAGE_LOSS) == 0;
  }

  /** The longest delay of a message without faults, in ns. */
  long delayNs() {
    return settings.messageDelay().longestNs();
  }

  /**
   * Promises service in a calm world, if the network has no loss then.
   *
   * @param promptMs the bound on one request, with messages that take no time
   * @param messages how many messages one request waits for, one after another
   * @param mayFail whether requests may fail in a calm world, too
   */
  void promise(long promptMs, int messages, boolean mayFail) {
    if (isLossless()) {
      long promptNs = withMessagesNs(promptMs, messages);
      simulation.monitor(() -> new ServiceSpec(promptNs, mayFail));
    }
  }

  /** A time, and the longest delays of so many messages one after another, in ns. */
  long withMessagesNs(long ms, int messages) {
    return ms * Time.NS_PER_MS + messages * delayNs();
  }

  /**
   * Time within which a primitive that needs a few rounds of messages has answered, while no fault but
   * crashes is active.
   */
  long withinNs() {
    return (isLossless() ? 5 : 10) * deltaNs(settings);
  }

  /** A deadline after {@link #withinNs}: a late answer violates the specification first. */
  long deadlineMs() {
    return 15 * deltaNs(settings) / Time.NS_PER_MS;
  }

  /** As {@link #deadlineMs}, or shorter than outages if {@link #PATIENCE} says so. */
  long drawnDeadlineMs() {
    return request.choice(PATIENCE).equals(SHORT) ? SHORT_MS : deadlineMs();
  }

  RegistrationSettings registration() {
    return RegistrationSettings.DEFAULT.withDeadlineMs(deadlineMs());
  }
}
