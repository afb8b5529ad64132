package org.starl.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.RobotType;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.sim.net.Latency;
import org.starl.sim.net.Loss;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.WorldLimits;

/**
 * A value for each {@link Setting} of a simulation. Immutable; made by a builder, in code by
 * constant ({@code set(Setting.ROBOTS, 8)}) or by text ({@code set("robots", "8")}).
 */
public final class SimSettings {

  private static final double IDEAL_RAD_PER_S = 1000;
  private static final double WHEEL_TRACK_MM = 258;
  private static final long MOST_CHAOS_NS = 60_000_000_000L;

  private final Map<Setting<?>, Object> values;

  private SimSettings(Map<Setting<?>, Object> values) {
    this.values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  /** A builder that stands at the defaults. */
  public static Builder builder() {
    return new Builder();
  }

  /** Every setting at its default. */
  public static SimSettings defaults() {
    return builder().build();
  }

  /** A builder that stands at these values. */
  public Builder toBuilder() {
    Builder builder = new Builder();
    builder.values.putAll(values);
    return builder;
  }

  /** The value of one setting. */
  public <T> T get(Setting<T> setting) {
    Object value = values.get(setting);
    return value == null ? setting.defaultValue() : setting.cast(value);
  }

  /** Every key with its value as text, in the table's order; what {@code set} reads back. */
  public Map<String, String> asText() {
    Map<String, String> text = new LinkedHashMap<>();
    for (Setting<?> setting : Setting.all()) {
      text.put(setting.key(), setting.text(get(setting)));
    }
    return text;
  }

  /** When chaos is over, if there is any. */
  public long chaosEndNs() {
    long wantedNs = get(Setting.CHAOS_FOR).toNanos();
    return wantedNs > 0 ? wantedNs : Math.min(endNs() / 2, MOST_CHAOS_NS);
  }

  public int robots() {
    return get(Setting.ROBOTS);
  }

  /** How many robots neither explore nor wander. */
  public int goalRobots() {
    return robots() - get(Setting.DISCOVERY_ROBOTS) - get(Setting.RANDOM_ROBOTS);
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
   * Speeds at most {@code maxSpeed} a wheel, for wheels as far apart as the Create's; ideal bodies
   * turn as fast as they are told.
   */
  public WorldLimits worldLimits() {
    double maxMmPerS = get(Setting.MAX_SPEED);
    return get(Setting.IDEAL_MOTION)
        ? new WorldLimits(maxMmPerS, IDEAL_RAD_PER_S, false)
        : new WorldLimits(maxMmPerS, 2 * maxMmPerS / WHEEL_TRACK_MM, true);
  }

  /** How robot number {@code index} of these moves, unless its app says otherwise. */
  public MotionParameters motionParameters(int index) {
    return motionParameters(robotType(index));
  }

  MotionParameters motionParameters(RobotType type) {
    return MotionParameters.builder()
        .style(get(Setting.IDEAL_MOTION) ? MotionStyle.IDEAL : MotionStyle.UNICYCLE)
        .robotRadiusMm(robotRadiusMm())
        .contactMarkMm(get(Setting.CONTACT_MARK))
        .speedError(speedError())
        .robotType(type)
        .collisionPolicy(get(Setting.COLLISION_POLICY))
        .build();
  }

  /** The last of the robots explore and wander; all others, late ones too, go to their goals. */
  RobotType robotType(int index) {
    int firstDiscovery = goalRobots();
    int firstRandom = firstDiscovery + get(Setting.DISCOVERY_ROBOTS);
    if (index >= firstRandom && index < robots()) {
      return RobotType.RANDOM_MOVER;
    }
    return index >= firstDiscovery && index < firstRandom ? RobotType.DISCOVERY : RobotType.GOAL;
  }

  /** Robots are called so, with their number behind. */
  public String robotName() {
    return get(Setting.ROBOT_NAME);
  }

  /** Time until a write to stable storage survives a crash. */
  public long stableDelayNs() {
    return get(Setting.STABLE_DELAY).toNanos();
  }

  /** What a computation off the strand costs. */
  public long computeTimeNs() {
    return get(Setting.COMPUTE_TIME).toNanos();
  }

  /** Wheels' error; none with ideal motion. */
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

  /** Collects values; each is checked when it is set, and all together in {@link #build}. */
  public static final class Builder {
    private final Map<Setting<?>, Object> values = new LinkedHashMap<>();

    private Builder() {}

    /** @throws BadInput if the value is out of the setting's range */
    public <T> Builder set(Setting<T> setting, T value) {
      values.put(setting, setting.checked(value));
      return this;
    }

    /**
     * Sets by text, as {@code --set key=value} does.
     *
     * @throws BadInput if there is no such key, naming those that look like it, or the value is not
     *     what was expected
     */
    public Builder set(String key, String value) {
      List<String> keys = new ArrayList<>();
      for (Setting<?> setting : Setting.all()) {
        if (setting.key().equals(key)) {
          values.put(setting, setting.read(value));
          return this;
        }
        keys.add(setting.key());
      }
      throw new BadInput(
          "no setting is called " + BadInput.quote(key) + NearMatches.hint(key, keys));
    }

    public Builder robots(int robots) {
      return set(Setting.ROBOTS, robots);
    }

    public Builder duration(Duration duration) {
      return set(Setting.DURATION, duration);
    }

    public Builder messageDelay(Latency delay) {
      return set(Setting.MESSAGE_DELAY, delay);
    }

    public Builder messageLoss(double probability) {
      return set(Setting.MESSAGE_LOSS, probability);
    }

    /** @throws BadInput if the values do not fit each other */
    public SimSettings build() {
      SimSettings settings = new SimSettings(values);
      if (settings.goalRobots() < 0) {
        throw new BadInput(
            "discoveryRobots="
                + settings.get(Setting.DISCOVERY_ROBOTS)
                + " and randomRobots="
                + settings.get(Setting.RANDOM_ROBOTS)
                + ": expected no more than robots="
                + settings.robots()
                + " together");
      }
      if (settings.get(Setting.SPEED_ERROR) >= 1) {
        throw new BadInput("speedError=1: expected a fraction below 1");
      }
      return settings;
    }
  }
}
