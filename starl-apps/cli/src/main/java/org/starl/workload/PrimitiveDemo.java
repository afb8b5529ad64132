package org.starl.workload;

import java.time.Duration;
import java.util.OptionalInt;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;

/** A primitive's workload as the command line knows it. */
abstract class PrimitiveDemo implements Demo {

  /** Robots start so far apart that none is in another one's way. */
  static final double SPACING_MM = 3000;

  private static final String ROUNDS = "rounds";
  private static final String BUSY = "busy";
  private static final int MAX_ROUNDS = 1000;
  private static final long NS_PER_MS = 1_000_000;
  private static final int DEFAULT_ROBOTS = 5;

  private final String name;
  private final String summary;

  PrimitiveDemo(String name, String summary) {
    this.name = name;
    this.summary = summary;
  }

  @Override
  public final Kind kind() {
    return Kind.PRIMITIVE;
  }

  @Override
  public final String name() {
    return name;
  }

  @Override
  public final String summary() {
    return summary;
  }

  static Parameter rounds(int count) {
    return new Parameter(
        ROUNDS,
        Integer.toString(count),
        "how often each robot asks, from 1",
        Form.whole(1, MAX_ROUNDS));
  }

  static Parameter busy(String duration) {
    return new Parameter(
        BUSY,
        duration,
        "rounds, and chaos, are spread over so long; the last three begin after it",
        Form.amount(Quantity.DURATION));
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder()
        .set(Setting.CHAOS_FOR, Duration.ofMillis(durationMs(request, BUSY)));
  }

  @Override
  public final Plan plan(Request request, SimSettings settings) {
    RoundsStory story = new RoundsStory();
    Simulation.Builder simulation = Simulation.builder().settings(settings).observer(story);
    prepare(simulation, request, settings);
    Obstacles obstacles = obstacles(request);
    simulation.obstacles(obstacles);
    return new Plan(simulation, story, Layer.NONE, obstacles);
  }

  /** Adds robots and monitors. */
  abstract void prepare(Simulation.Builder simulation, Request request, SimSettings settings);

  /** What stands on the floor. */
  Obstacles obstacles(Request request) {
    return Obstacles.NONE;
  }

  static Course course(Request request) {
    return new Course(whole(request, ROUNDS, 1, MAX_ROUNDS), durationMs(request, BUSY));
  }

  static long durationMs(Request request, String key) {
    try {
      return Quantities.durationNs(request.parameter(key)) / NS_PER_MS;
    } catch (BadInput error) {
      throw Quantities.in(key, error);
    }
  }

  static int whole(Request request, String key, int least, int most) {
    try {
      return (int) Quantities.whole(request.parameter(key), least, most);
    } catch (BadInput error) {
      throw Quantities.in(key, error);
    }
  }

  /** How many robots: what the user says, else five. */
  static int count(Request request, int least, int most) {
    OptionalInt wanted = request.robots();
    int count = wanted.orElse(DEFAULT_ROBOTS);
    if (count < least || count > most) {
      throw new BadInput("robots: " + count + ": expected " + least + " to " + most);
    }
    return count;
  }

  /** Puts robots on a square grid. */
  static void place(
      Simulation.Builder simulation,
      SimSettings settings,
      int count,
      Function<GlobalVarHolder, ? extends Client> client) {
    int side = (int) Math.ceil(Math.sqrt(count));
    for (int i = 0; i < count; i++) {
      int column = i % side;
      int row = i / side;
      Pose start = new Pose(SPACING_MM * (column + 0.5), SPACING_MM * (row + 0.5), 0);
      simulation.robot(new RobotSpec(new RobotId(settings.robotName() + i), start, true, client));
    }
  }
}
