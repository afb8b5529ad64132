package org.starl.sim;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.RobotType;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.net.Latency;
import org.starl.sim.net.Loss;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.WorldLimits;
import org.starl.time.Time;

/**
 * Typed values of {@link Setting}s: the values that were set, and the defaults of the others.
 * Immutable. Command line, scenario files, trace headers and Java code use the same builder: by
 * name ({@code robots(8)}: a method for each key), by constant ({@code set(Setting.ROBOTS, 8)}) or by
 * text ({@code set("robots", "8")}), which is parsed only there.
 */
public final class SimSettings {

  private static final double IDEAL_RAD_PER_S = 1000;
  private static final double WHEEL_TRACK_MM = 258;
  private static final long MOST_CHAOS_NS = 60 * Time.NS_PER_S;

  private final Map<Setting<?>, Object> values;

  private SimSettings(Map<Setting<?>, Object> values) {
    this.values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  /** A builder without values. */
  public static Builder builder() {
    return new Builder();
  }

  /** Every setting at its default. */
  public static SimSettings defaults() {
    return builder().build();
  }

  /** A builder initialized with these values. */
  public Builder toBuilder() {
    Builder builder = new Builder();
    builder.values.putAll(values);
    return builder;
  }

  /** A copy with one value replaced. @throws BadInput if the value is out of the setting's range */
  public <T> SimSettings with(Setting<T> setting, T value) {
    return toBuilder().set(setting, value).build();
  }

  /** The value of one setting. */
  public <T> T get(Setting<T> setting) {
    Object value = values.get(setting);
    return value == null ? setting.defaultValue() : setting.cast(value);
  }

  /** Whether a value was set explicitly, even if it equals the default. */
  public boolean has(Setting<?> setting) {
    return values.containsKey(setting);
  }

  /** These values where set, otherwise those of {@code defaults}. */
  public SimSettings over(SimSettings defaults) {
    Map<Setting<?>, Object> both = new LinkedHashMap<>(defaults.values);
    both.putAll(values);
    return new SimSettings(both);
  }

  /** A copy with only the settings in {@code keys}. */
  public SimSettings only(Predicate<Setting<?>> keys) {
    Map<Setting<?>, Object> kept = new LinkedHashMap<>(values);
    kept.keySet().removeIf(keys.negate());
    return new SimSettings(kept);
  }

  /** The settings that were set, with their values as text, in the order in which they were set. */
  public Map<Setting<?>, String> given() {
    Map<Setting<?>, String> text = new LinkedHashMap<>();
    values.forEach((setting, value) -> text.put(setting, setting.text(value)));
    return text;
  }

  /**
   * Every key with its value as text, which {@code set} reads back: the simulator's keys in the
   * order of {@link Setting#all}, {@link Setting#HEADER_IF_GIVEN} only if they were set, then other
   * keys that were set.
   */
  public Map<String, String> asText() {
    Map<String, String> text = new LinkedHashMap<>();
    for (Setting<?> setting : Setting.all()) {
      if (!Setting.HEADER_IF_GIVEN.contains(setting) || has(setting)) {
        text.put(setting.key(), setting.text(get(setting)));
      }
    }
    given().forEach((setting, value) -> text.put(setting.key(), value));
    return text;
  }

  /** The time, in ns, at which all faults of chaos have ended. */
  public long chaosEndNs() {
    long wantedNs = get(Setting.CHAOS_FOR).toNanos();
    return wantedNs > 0 ? wantedNs : Math.min(endNs() / 2, MOST_CHAOS_NS);
  }

  public int robots() {
    return get(Setting.ROBOTS);
  }

  /** Simulated time after which the run ends, or {@code Long.MAX_VALUE}. */
  public long endNs() {
    Duration duration = get(Setting.DURATION);
    return duration.isZero() ? Long.MAX_VALUE : duration.toNanos();
  }

  public Latency messageDelay() {
    return get(Setting.MESSAGE_DELAY);
  }

  public Loss messageLoss() {
    return new Loss(get(Setting.MESSAGE_LOSS));
  }

  /** Whether faults are given or drawn; the network's own loss is none. */
  public boolean hasFaults() {
    return !get(Setting.FAULTS).isEmpty() || get(Setting.CHAOS) != Envelope.NONE;
  }

  public double robotRadiusMm() {
    return get(Setting.ROBOT_RADIUS);
  }

  public long positionPeriodNs() {
    return get(Setting.POSITION_PERIOD).toNanos();
  }

  public PositionNoise positionNoise() {
    return new PositionNoise(get(Setting.POSITION_NOISE), get(Setting.HEADING_NOISE));
  }

  /**
   * Speed limits: {@code maxSpeed} for each wheel, with the wheel track of the Create. Ideal bodies
   * have no turning limit.
   */
  public WorldLimits worldLimits() {
    double maxMmPerS = get(Setting.MAX_SPEED);
    return get(Setting.IDEAL_MOTION)
        ? new WorldLimits(maxMmPerS, IDEAL_RAD_PER_S, false, false)
        : new WorldLimits(maxMmPerS, 2 * maxMmPerS / WHEEL_TRACK_MM, true, speedError() > 0);
  }

  /** The motion parameters of robot number {@code index}, unless its app sets others. */
  public MotionParameters motionParameters(int index) {
    return motionParameters(index, robots());
  }

  /**
   * The motion parameters of robot number {@code index} of initially {@code robots}, unless its app
   * sets others.
   */
  public MotionParameters motionParameters(int index, int robots) {
    return motionParameters(robotType(index, robots));
  }

  MotionParameters motionParameters(RobotType type) {
    MotionParameters usual = MotionParameters.DEFAULT;
    double most = get(Setting.MAX_SPEED);
    return MotionParameters.builder()
        .linSpeedMaxMmPerS(Math.min(usual.linSpeedMaxMmPerS(), most))
        .linSpeedMinMmPerS(Math.min(usual.linSpeedMinMmPerS(), most))
        .arcSpeedMaxMmPerS(Math.min(usual.arcSpeedMaxMmPerS(), most))
        .style(get(Setting.IDEAL_MOTION) ? MotionStyle.IDEAL : MotionStyle.UNICYCLE)
        .robotRadiusMm(robotRadiusMm())
        .contactMarkMm(get(Setting.CONTACT_MARK))
        .speedError(speedError())
        .reactionMs(get(Setting.REACTION).toMillis())
        .robotType(type)
        .collisionPolicy(get(Setting.COLLISION_POLICY))
        .build();
  }

  /**
   * The type of robot number {@code index} of initially {@code robots}: the last ones wander, those
   * before them explore; all others, including those that join later, drive to goals.
   */
  RobotType robotType(int index, int robots) {
    int firstRandom = robots - get(Setting.RANDOM_ROBOTS);
    int firstDiscovery = firstRandom - get(Setting.DISCOVERY_ROBOTS);
    if (index < firstDiscovery || index >= robots) {
      return RobotType.GOAL;
    }
    return index < firstRandom ? RobotType.DISCOVERY : RobotType.RANDOM_MOVER;
  }

  /**
   * Those of the robots that start which leave their way: the settings {@code discoveryRobots} and
   * {@code randomRobots}. A lemma that needs them on their way is not required of them.
   *
   * @param robots all robots that start, in the order in which the simulation gets them
   */
  public List<RobotId> strayRobots(List<RobotId> robots) {
    int ordinary = robots.size() - get(Setting.RANDOM_ROBOTS) - get(Setting.DISCOVERY_ROBOTS);
    return robots.subList(Math.max(0, ordinary), robots.size());
  }

  /** The first part of robots' names, before the number. */
  public String robotName() {
    return get(Setting.ROBOT_NAME);
  }

  /** Time until a write to stable storage survives a crash. */
  public long stableDelayNs() {
    return get(Setting.STABLE_DELAY).toNanos();
  }

  /** Time of a computation off the strand, in ns. */
  public long computeTimeNs() {
    return get(Setting.COMPUTE_TIME).toNanos();
  }

  /** Largest relative error of a wheel speed; 0 with ideal motion. */
  public double speedError() {
    return get(Setting.IDEAL_MOTION) ? 0 : get(Setting.SPEED_ERROR);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SimSettings that && asText().equals(that.asText());
  }

  @Override
  public int hashCode() {
    return asText().hashCode();
  }

  @Override
  public String toString() {
    return asText().toString();
  }

  /**
   * Collects values. Each value is checked when it is set; consistency is checked when the
   * simulation is built.
   */
  public static final class Builder {
    private final Map<Setting<?>, Object> values = new LinkedHashMap<>();

    private Builder() {}

    /** @throws BadInput if the value is out of the setting's range */
    public <T> Builder set(Setting<T> setting, T value) {
      values.put(setting, setting.checked(value));
      return this;
    }

    /**
     * Sets one of the simulator's settings by text, as {@code --set key=value} does.
     *
     * @throws BadInput if there is no such key, naming those that look like it, or the value is not
     *     what was expected
     */
    public Builder set(String key, String value) {
      for (Setting<?> setting : Setting.all()) {
        if (setting.key().equals(key)) {
          return read(setting, value);
        }
      }
      List<String> keys = Setting.all().stream().map(Setting::key).toList();
      throw new BadInput(
          "no setting is called " + BadInput.quote(key) + NearMatches.hint(key, keys));
    }

    /** Sets by text. @throws BadInput if the value is not what was expected */
    public Builder read(Setting<?> setting, String value) {
      values.put(setting, setting.read(value));
      return this;
    }

    // A method for each key of --set, with the setting's unit; Setting documents them.

    public Builder robots(int count) {
      return set(Setting.ROBOTS, count);
    }

    public Builder discoveryRobots(int count) {
      return set(Setting.DISCOVERY_ROBOTS, count);
    }

    public Builder randomRobots(int count) {
      return set(Setting.RANDOM_ROBOTS, count);
    }

    public Builder duration(Duration simulated) {
      return set(Setting.DURATION, simulated);
    }

    public Builder floorWidth(double widthMm) {
      return set(Setting.FLOOR_WIDTH, widthMm);
    }

    public Builder floorHeight(double heightMm) {
      return set(Setting.FLOOR_HEIGHT, heightMm);
    }

    public Builder obstacleFile(String path) {
      return set(Setting.OBSTACLE_FILE, path);
    }

    public Builder startFile(String path) {
      return set(Setting.START_FILE, path);
    }

    public Builder startSpacing(double bodyRadii) {
      return set(Setting.START_SPACING, bodyRadii);
    }

    public Builder robotName(String firstPart) {
      return set(Setting.ROBOT_NAME, firstPart);
    }

    public Builder robotRadius(double radiusMm) {
      return set(Setting.ROBOT_RADIUS, radiusMm);
    }

    public Builder idealMotion(boolean on) {
      return set(Setting.IDEAL_MOTION, on);
    }

    public Builder maxSpeed(double mmPerS) {
      return set(Setting.MAX_SPEED, mmPerS);
    }

    public Builder collisionPolicy(CollisionPolicy policy) {
      return set(Setting.COLLISION_POLICY, policy);
    }

    public Builder speedError(double fraction) {
      return set(Setting.SPEED_ERROR, fraction);
    }

    public Builder reaction(Duration time) {
      return set(Setting.REACTION, time);
    }

    public Builder positionPeriod(Duration period) {
      return set(Setting.POSITION_PERIOD, period);
    }

    public Builder positionNoise(double boundMm) {
      return set(Setting.POSITION_NOISE, boundMm);
    }

    public Builder headingNoise(double boundRad) {
      return set(Setting.HEADING_NOISE, boundRad);
    }

    public Builder positionInPhase(boolean on) {
      return set(Setting.POSITION_IN_PHASE, on);
    }

    public Builder stableDelay(Duration delay) {
      return set(Setting.STABLE_DELAY, delay);
    }

    public Builder computeTime(Duration time) {
      return set(Setting.COMPUTE_TIME, time);
    }

    public Builder messageDelay(Latency delay) {
      return set(Setting.MESSAGE_DELAY, delay);
    }

    public Builder messageLoss(double probability) {
      return set(Setting.MESSAGE_LOSS, probability);
    }

    public Builder radioRange(double mm) {
      return set(Setting.RADIO_RANGE, mm);
    }

    public Builder radioSight(boolean on) {
      return set(Setting.RADIO_SIGHT, on);
    }

    public Builder sealed(boolean on) {
      return set(Setting.SEALED, on);
    }

    public Builder faults(FaultPlan plan) {
      return set(Setting.FAULTS, plan);
    }

    public Builder chaos(Envelope envelope) {
      return set(Setting.CHAOS, envelope);
    }

    public Builder chaosFor(Duration time) {
      return set(Setting.CHAOS_FOR, time);
    }

    public Builder redraws(Redraws times) {
      return set(Setting.REDRAWS, times);
    }

    public Builder contactMark(double sideMm) {
      return set(Setting.CONTACT_MARK, sideMm);
    }

    public SimSettings build() {
      return new SimSettings(values);
    }
  }
}
