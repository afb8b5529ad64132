package org.starl.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.net.Latency;
import org.starl.time.Time;

/**
 * One setting: its key in {@code --set key=value}, its meaning, its default, and how its text is read
 * and written. The constants are the simulator's own; a viewer adds others by the factory methods.
 * {@link SimSettings} holds the values.
 *
 * @param <T> the type of its values
 */
public final class Setting<T> {

  // Filled by the constants, in their order.
  private static final List<Setting<?>> TABLE = new ArrayList<>();

  // The run.
  public static final Setting<Integer> ROBOTS = count("robots", 4, "number of robots that start");
  public static final Setting<Integer> DISCOVERY_ROBOTS =
      count("discoveryRobots", 0, "how many of these robots follow what they bump into");
  public static final Setting<Integer> RANDOM_ROBOTS =
      count(
          "randomRobots",
          0,
          "how many of these robots wander: turn and drive at random before each motion");
  public static final Setting<Duration> DURATION =
      own(
          "duration",
          SettingType.DURATION,
          Duration.ofMinutes(20),
          "simulated time after which the run ends; 0ms for no limit");

  // The floor.
  public static final Setting<Double> FLOOR_WIDTH =
      size("floorWidth", 5000.0, "size of the floor along x");
  public static final Setting<Double> FLOOR_HEIGHT =
      size("floorHeight", 3000.0, "size of the floor along y");
  public static final Setting<String> OBSTACLE_FILE =
      text("obstacleFile", "file of obstacles (Obstacle and Hidden lines, or DXF); empty for none");
  public static final Setting<String> START_FILE =
      text("startFile", "file of start poses (WAY lines with robots' names); empty: drawn by seed");
  public static final Setting<Double> START_SPACING =
      own(
          "startSpacing",
          SettingType.NUMBER,
          2.8,
          "least distance of drawn starts between centres, in body radii");

  // The bodies.
  public static final Setting<String> ROBOT_NAME =
      own(
          "robotName",
          new SettingType<>(
              String.class,
              String::strip,
              text -> text,
              text -> RobotId.isValid(text + "00000000"),
              "a letter, then up to 23 of A-Z a-z 0-9 _ - ., and no number after the last dot",
              new Form.Text("^\\s*(?!.*\\.[0-9]*\\s*$)[A-Za-z][A-Za-z0-9_.-]{0,23}\\s*$")),
          "bot",
          "first part of robots' names; a number from 0 follows");
  public static final Setting<Double> ROBOT_RADIUS =
      size("robotRadius", 165.0, "radius of a robot's body");
  public static final Setting<Boolean> IDEAL_MOTION =
      flag("idealMotion", false, "bodies pass through everything, wheel speeds are exact");
  public static final Setting<Double> MAX_SPEED =
      own("maxSpeed", SettingType.SPEED, 500.0, "largest speed of a body");
  public static final Setting<CollisionPolicy> COLLISION_POLICY =
      own(
          "collisionPolicy",
          SettingType.choice(CollisionPolicy.class, Setting::collisionPolicy),
          CollisionPolicy.STOP_ON_COLLISION,
          "reaction to a bump: BUMPERCARS, STOP_ON_COLLISION, USE_COLAVOID or USE_COLBACK");
  public static final Setting<Double> SPEED_ERROR =
      probability("speedError", "largest relative error of a wheel speed, drawn per command");

  /** In a trace's header only if it was given: traces without it are as before. */
  public static final Setting<Duration> REACTION =
      duration(
          "reaction",
          "longest time until a wheel command is in effect, drawn per command; robots allow for it;"
              + " in a deployment its reactionMs");

  // Positioning, clocks and storage.
  public static final Setting<Duration> POSITION_PERIOD =
      own(
          "positionPeriod",
          SettingType.PERIOD,
          Duration.ofMillis(75),
          "time between two fixes of a robot");
  public static final Setting<Double> POSITION_NOISE =
      own("positionNoise", SettingType.DISTANCE, 0.0, "largest error of a position fix");
  public static final Setting<Double> HEADING_NOISE =
      own("headingNoise", SettingType.ANGLE, 0.0, "largest error of the heading in a fix");
  public static final Setting<Boolean> POSITION_IN_PHASE =
      flag("positionInPhase", false, "all robots get their fixes at the same times");
  public static final Setting<Duration> STABLE_DELAY =
      duration("stableDelay", "time until a write to stable storage survives a crash");
  public static final Setting<Duration> COMPUTE_TIME =
      duration("computeTime", "time of a robot's long computation, such as planning a path");

  // The network.
  public static final Setting<Latency> MESSAGE_DELAY =
      own(
          "messageDelay",
          SettingType.unlimited(
              Latency.class, Latency::parse, Latency::toString, new Form.Text(Latency.PATTERN)),
          new Latency.Uniform(10 * Time.NS_PER_MS, 20 * Time.NS_PER_MS),
          "delay of a datagram: 100ms, uniform(..), normal(..), exponential(..)");
  public static final Setting<Double> MESSAGE_LOSS =
      probability("messageLoss", "probability that a datagram is lost, for each recipient");

  /** In a trace's header only if it was given, as the next one. */
  public static final Setting<Double> RADIO_RANGE =
      own(
          "radioRange",
          SettingType.DISTANCE,
          0.0,
          "range of a radio, between centres; 0 for no limit");

  public static final Setting<Boolean> RADIO_SIGHT =
      flag(
          "radioSight",
          false,
          "with radioRange: radios need a line of sight, free of walls and bodies");
  public static final Setting<Boolean> SEALED =
      flag("sealed", false, "seal datagrams with a key that all robots of the run share");

  // Faults.
  public static final Setting<FaultPlan> FAULTS =
      own(
          "faults",
          SettingType.unlimited(
              FaultPlan.class, FaultPlan::parse, FaultPlan::toString, Form.FAULTS),
          FaultPlan.NONE,
          "faults to inject, with ; between them; see below");

  public static final Setting<Envelope> CHAOS =
      own(
          "chaos",
          SettingType.choice(Envelope.class, Envelope::parse),
          Envelope.NONE,
          "faults drawn by seed: " + Arrays.toString(Envelope.values()));
  public static final Setting<Duration> CHAOS_FOR =
      duration("chaosFor", "time after which chaos has ended; 0ms: half of the run, at most 60s");

  /** In a trace's header only if it was given: traces without it are as before. */
  public static final Setting<Redraws> REDRAWS =
      own(
          "redraws",
          SettingType.unlimited(
              Redraws.class, Redraws::parse, Redraws::toString, new Form.Text(Redraws.PATTERN)),
          Redraws.NONE,
          "times at which the run begins to draw other random numbers: 12.3s#17; with ; between"
              + " them");

  // What robots learn of hidden obstacles.
  public static final Setting<Double> CONTACT_MARK =
      size(
          "contactMark",
          MotionParameters.DEFAULT.contactMarkMm(),
          "side of the square that a bump adds to a robot's map");

  /** Those that a trace's header has only if they were given: traces without them are as before. */
  static final Set<Setting<?>> HEADER_IF_GIVEN =
      Set.of(REACTION, REDRAWS, RADIO_RANGE, RADIO_SIGHT);

  private final String key;
  private final SettingType<T> type;
  private final T defaultValue;
  private final String meaning;

  private Setting(String key, SettingType<T> type, T defaultValue, String meaning) {
    this.key = key;
    this.type = type;
    this.defaultValue = defaultValue;
    this.meaning = meaning;
  }

  private static <T> Setting<T> own(
      String key, SettingType<T> type, T defaultValue, String meaning) {
    Setting<T> setting = new Setting<>(key, type, defaultValue, meaning);
    TABLE.add(setting);
    return setting;
  }

  private static Setting<Integer> count(String key, int initial, String meaning) {
    return own(key, SettingType.whole(0), initial, meaning);
  }

  private static Setting<Double> size(String key, double initialMm, String meaning) {
    return own(key, SettingType.SIZE, initialMm, meaning);
  }

  private static Setting<Double> probability(String key, String meaning) {
    return own(key, SettingType.PROBABILITY, 0.0, meaning);
  }

  private static Setting<Duration> duration(String key, String meaning) {
    return own(key, SettingType.DURATION, Duration.ZERO, meaning);
  }

  private static Setting<Boolean> flag(String key, boolean initial, String meaning) {
    return own(key, SettingType.YES_NO, initial, meaning);
  }

  private static Setting<String> text(String key, String meaning) {
    return own(key, SettingType.TEXT, "", meaning);
  }

  /** A whole number of at least {@code least}. */
  public static Setting<Integer> whole(String key, int initial, int least, String meaning) {
    return new Setting<>(key, SettingType.whole(least), initial, meaning);
  }

  /** A number of at least 0. */
  public static Setting<Double> number(String key, double initial, String meaning) {
    return new Setting<>(key, SettingType.NUMBER, initial, meaning);
  }

  /** Yes or no. */
  public static Setting<Boolean> yesOrNo(String key, boolean initial, String meaning) {
    return new Setting<>(key, SettingType.YES_NO, initial, meaning);
  }

  /** The simulator's settings, in the order to show them. */
  public static List<Setting<?>> all() {
    return Collections.unmodifiableList(TABLE);
  }

  /** Its name in {@code --set key=value}. */
  public String key() {
    return key;
  }

  /** One line for users. */
  public String meaning() {
    return meaning;
  }

  /** The values it takes. */
  public Form form() {
    return type.form();
  }

  public T defaultValue() {
    return defaultValue;
  }

  /** The default as text, which {@code --set} reads. */
  public String defaultText() {
    return type.writer().apply(defaultValue);
  }

  /** @throws BadInput naming key, text and what was expected */
  T read(String text) {
    T value;
    try {
      value = type.reader().apply(text);
    } catch (BadInput unreadable) {
      throw new BadInput(key + "=" + unreadable.getMessage());
    }
    return checked(value);
  }

  /** @throws BadInput if the value is out of range */
  T checked(T value) {
    if (!type.validity().test(value)) {
      throw new BadInput(key + "=" + type.writer().apply(value) + ": expected " + type.expected());
    }
    return value;
  }

  String text(Object value) {
    return type.writer().apply(cast(value));
  }

  T cast(Object value) {
    return type.values().cast(value);
  }

  @Override
  public String toString() {
    return key;
  }

  private static CollisionPolicy collisionPolicy(String text) {
    for (CollisionPolicy policy : CollisionPolicy.values()) {
      if (policy.name().equals(text.strip())) {
        return policy;
      }
    }
    throw new BadInput(
        BadInput.quote(text) + ": expected one of " + Arrays.toString(CollisionPolicy.values()));
  }
}
