package org.starl.sim;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.net.Latency;

/**
 * One setting: its key in {@code --set key=value}, its meaning, its default, and how its text is read
 * and written. The constants are the simulator's own; a viewer adds others by the factory methods.
 * {@link SimSettings} holds the values.
 *
 * @param <T> the type of its values
 */
public final class Setting<T> {

  // The run.
  public static final Setting<Integer> ROBOTS =
      whole("robots", 4, 0, "number of robots that start");
  public static final Setting<Integer> DISCOVERY_ROBOTS =
      whole("discoveryRobots", 0, 0, "number of these that explore by bumping");
  public static final Setting<Integer> RANDOM_ROBOTS =
      whole("randomRobots", 0, 0, "number of these that wander and get in the way");
  public static final Setting<Duration> DURATION =
      duration("duration", 0, "simulated time after which the run ends; 0ms for no limit");

  // The floor.
  public static final Setting<Double> FLOOR_WIDTH =
      distance("floorWidth", 5000, "size of the floor along x");
  public static final Setting<Double> FLOOR_HEIGHT =
      distance("floorHeight", 3000, "size of the floor along y");
  public static final Setting<String> OBSTACLE_FILE =
      text("obstacleFile", "", "file of obstacles (Obstacle and Hidden lines); empty for none");
  public static final Setting<String> START_FILE =
      text(
          "startFile",
          "",
          "file of start poses (WAY lines with robots' names); empty: drawn by seed");
  public static final Setting<Double> START_SPACING =
      number("startSpacing", 2.8, "least distance of drawn starts between centres, in body radii");

  // The bodies.
  public static final Setting<String> ROBOT_NAME =
      new Setting<>(
          "robotName",
          String.class,
          "bot",
          "first part of robots' names, before a number from 0",
          String::strip,
          text -> text,
          text -> RobotId.isValid(text + "00000000"),
          "a letter, then up to 23 of A-Z a-z 0-9 _ - .",
          new Form.Text("^\\s*[A-Za-z][A-Za-z0-9_.-]{0,23}\\s*$"));
  public static final Setting<Double> ROBOT_RADIUS =
      distance("robotRadius", 165, "radius of a robot's body");
  public static final Setting<Boolean> IDEAL_MOTION =
      yesOrNo("idealMotion", false, "bodies pass through everything, wheel speeds are exact");
  public static final Setting<Double> MAX_SPEED =
      new Setting<>(
          "maxSpeed",
          Double.class,
          500.0,
          "largest speed of a body",
          Quantities::speedMmPerS,
          Quantities::speedText,
          value -> value > 0,
          "a speed above 0",
          Form.above0(Quantity.SPEED));
  public static final Setting<CollisionPolicy> COLLISION_POLICY =
      new Setting<>(
          "collisionPolicy",
          CollisionPolicy.class,
          CollisionPolicy.STOP_ON_COLLISION,
          "reaction to a bump: BUMPERCARS, STOP_ON_COLLISION, USE_COLAVOID or USE_COLBACK",
          Setting::collisionPolicy,
          CollisionPolicy::name,
          value -> true,
          "a collision policy",
          Form.choice(Arrays.stream(CollisionPolicy.values()).map(CollisionPolicy::name).toList()));
  public static final Setting<Double> SPEED_ERROR =
      probability("speedError", "largest relative error of a wheel speed, drawn per command");

  // Positioning, clocks and storage.
  public static final Setting<Duration> POSITION_PERIOD =
      new Setting<>(
          "positionPeriod",
          Duration.class,
          Duration.ofMillis(75),
          "time between two fixes of a robot",
          Setting::readDuration,
          Setting::durationText,
          value -> !value.isZero() && !value.isNegative(),
          "a duration above 0",
          Form.above0(Quantity.DURATION));
  public static final Setting<Double> POSITION_NOISE =
      distance("positionNoise", 0, "largest error of a position fix");
  public static final Setting<Double> HEADING_NOISE =
      new Setting<>(
          "headingNoise",
          Double.class,
          0.0,
          "largest error of the heading in a fix",
          Quantities::angleRad,
          Quantities::angleText,
          value -> value >= 0 && value <= StrictMath.PI,
          "an angle from 0 to 180deg",
          Form.amount(Quantity.ANGLE));
  public static final Setting<Boolean> POSITION_IN_PHASE =
      yesOrNo("positionInPhase", false, "all robots get their fixes at the same times");
  public static final Setting<Duration> STABLE_DELAY =
      duration("stableDelay", 0, "time until a write to stable storage survives a crash");
  public static final Setting<Duration> COMPUTE_TIME =
      duration("computeTime", 0, "time of a robot's long computation, such as planning a path");

  // The network.
  public static final Setting<Latency> MESSAGE_DELAY =
      new Setting<>(
          "messageDelay",
          Latency.class,
          new Latency.Uniform(10_000_000, 20_000_000),
          "delay of a datagram: 100ms, uniform(..), normal(..), exponential(..)",
          Latency::parse,
          Latency::toString,
          value -> true,
          "a delay",
          new Form.Text(Latency.PATTERN));
  public static final Setting<Double> MESSAGE_LOSS =
      probability("messageLoss", "probability that a datagram is lost, for each recipient");
  public static final Setting<Boolean> SEALED =
      yesOrNo("sealed", false, "seal datagrams with a key that all robots of the run share");

  // Faults.
  public static final Setting<FaultPlan> FAULTS =
      new Setting<>(
          "faults",
          FaultPlan.class,
          FaultPlan.NONE,
          "faults to inject, with ; between them; see below",
          FaultPlan::parse,
          FaultPlan::toString,
          value -> true,
          "faults",
          Form.FAULTS);

  public static final Setting<Envelope> CHAOS =
      new Setting<>(
          "chaos",
          Envelope.class,
          Envelope.NONE,
          "faults drawn by seed: " + Arrays.toString(Envelope.values()),
          Envelope::parse,
          Envelope::toString,
          value -> true,
          "an envelope of faults",
          Form.choice(Arrays.stream(Envelope.values()).map(Envelope::toString).toList()));
  public static final Setting<Duration> CHAOS_FOR =
      duration(
          "chaosFor", 0, "time after which chaos has ended; 0ms: half of the run, at most 60s");

  // What robots learn of hidden obstacles.
  public static final Setting<Double> CONTACT_MARK =
      distance(
          "contactMark",
          MotionParameters.DEFAULT.contactMarkMm(),
          "side of the square that a bump adds to a robot's map");

  private static final List<Setting<?>> TABLE =
      List.of(
          ROBOTS,
          DISCOVERY_ROBOTS,
          RANDOM_ROBOTS,
          DURATION,
          FLOOR_WIDTH,
          FLOOR_HEIGHT,
          OBSTACLE_FILE,
          START_FILE,
          START_SPACING,
          ROBOT_NAME,
          ROBOT_RADIUS,
          IDEAL_MOTION,
          MAX_SPEED,
          COLLISION_POLICY,
          SPEED_ERROR,
          POSITION_PERIOD,
          POSITION_NOISE,
          HEADING_NOISE,
          POSITION_IN_PHASE,
          STABLE_DELAY,
          COMPUTE_TIME,
          MESSAGE_DELAY,
          MESSAGE_LOSS,
          SEALED,
          FAULTS,
          CHAOS,
          CHAOS_FOR,
          CONTACT_MARK);

  private final String key;
  private final Class<T> type;
  private final T defaultValue;
  private final String meaning;
  private final Function<String, T> reader;
  private final Function<T, String> writer;
  private final Function<T, Boolean> isValid;
  private final String expected;
  private final Form form;

  private Setting(
      String key,
      Class<T> type,
      T defaultValue,
      String meaning,
      Function<String, T> reader,
      Function<T, String> writer,
      Function<T, Boolean> isValid,
      String expected,
      Form form) {
    this.key = key;
    this.type = type;
    this.defaultValue = defaultValue;
    this.meaning = meaning;
    this.reader = reader;
    this.writer = writer;
    this.isValid = isValid;
    this.expected = expected;
    this.form = form;
  }

  /** The simulator's settings, in the order to show them. */
  public static List<Setting<?>> all() {
    return TABLE;
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
    return form;
  }

  public T defaultValue() {
    return defaultValue;
  }

  /** The default as text, which {@code --set} reads. */
  public String defaultText() {
    return writer.apply(defaultValue);
  }

  /** @throws BadInput naming key, text and what was expected */
  T read(String text) {
    T value;
    try {
      value = reader.apply(text);
    } catch (BadInput unreadable) {
      throw new BadInput(key + "=" + unreadable.getMessage());
    }
    return checked(value);
  }

  /** @throws BadInput if the value is out of range */
  T checked(T value) {
    if (!isValid.apply(value)) {
      throw new BadInput(key + "=" + writer.apply(value) + ": expected " + expected);
    }
    return value;
  }

  String text(Object value) {
    return writer.apply(type.cast(value));
  }

  T cast(Object value) {
    return type.cast(value);
  }

  @Override
  public String toString() {
    return key;
  }

  /** A whole number of at least {@code least}. */
  public static Setting<Integer> whole(String key, int initial, int least, String meaning) {
    return new Setting<>(
        key,
        Integer.class,
        initial,
        meaning,
        text -> (int) Quantities.whole(text, least, Integer.MAX_VALUE),
        String::valueOf,
        value -> value >= least,
        "a whole number of at least " + least,
        Form.whole(least, Integer.MAX_VALUE));
  }

  /** A number of at least 0. */
  public static Setting<Double> number(String key, double initial, String meaning) {
    return new Setting<>(
        key,
        Double.class,
        initial,
        meaning,
        Quantities::number,
        Quantities::numberText,
        Setting::isAmount,
        "a number of at least 0",
        Form.amount(Quantity.NUMBER));
  }

  private static Setting<Double> distance(String key, double initialMm, String meaning) {
    // A size, which is positive by default, cannot be 0; noise can.
    return new Setting<>(
        key,
        Double.class,
        initialMm,
        meaning,
        Quantities::distanceMm,
        Quantities::distanceText,
        value -> isAmount(value) && (value > 0 || initialMm == 0),
        initialMm > 0 ? "a distance above 0" : "a distance of at least 0",
        new Form.Amount(Quantity.DISTANCE, initialMm > 0));
  }

  private static Setting<Double> probability(String key, String meaning) {
    return new Setting<>(
        key,
        Double.class,
        0.0,
        meaning,
        Quantities::probability,
        Quantities::numberText,
        value -> value >= 0 && value <= 1,
        "a number from 0 to 1",
        Form.amount(Quantity.PROBABILITY));
  }

  private static Setting<Duration> duration(String key, long initialMs, String meaning) {
    return new Setting<>(
        key,
        Duration.class,
        Duration.ofMillis(initialMs),
        meaning,
        Setting::readDuration,
        Setting::durationText,
        value -> !value.isNegative(),
        "a duration of at least 0",
        Form.amount(Quantity.DURATION));
  }

  /** Yes or no. */
  public static Setting<Boolean> yesOrNo(String key, boolean initial, String meaning) {
    return new Setting<>(
        key,
        Boolean.class,
        initial,
        meaning,
        Quantities::yesOrNo,
        String::valueOf,
        value -> true,
        "true or false",
        Form.YES_NO);
  }

  private static Setting<String> text(String key, String initial, String meaning) {
    return new Setting<>(
        key,
        String.class,
        initial,
        meaning,
        String::strip,
        text -> text,
        value -> true,
        "a text",
        Form.TEXT);
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

  private static boolean isAmount(double value) {
    return value >= 0 && value < Double.POSITIVE_INFINITY;
  }

  private static Duration readDuration(String text) {
    return Duration.ofNanos(Quantities.durationNs(text));
  }

  private static String durationText(Duration duration) {
    return Quantities.durationText(duration.toNanos());
  }
}
