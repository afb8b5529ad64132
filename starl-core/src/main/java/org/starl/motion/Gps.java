package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Variables;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Platform;
import org.starl.platform.Positioning;
import org.starl.platform.StartNeeds;

/**
 * {@code gvh.gps}: this robot's location, filtered from the fixes of its positioning system and the
 * wheel commands (paper, section 5.1). Strand only.
 *
 * <p>Every position has an error bound that is certain as long as each fix's own bound is correct
 * and the body follows its commands within {@code speedError} and {@code reactionMs} of {@link
 * MotionParameters}; see {@link #errorMm}. A fix that contradicts all earlier ones is counted and
 * not used, and the bound also covers its position until a fix agrees again. Millimetres, radians
 * counter-clockwise, times on the robot's own clock.
 */
public final class Gps {

  private final Clock clock;
  private final Positioning positioning;
  private final PositionFilter filter = new PositionFilter();
  private final LocationVariable currentlocation = new LocationVariable(this);
  private final KnownObstacles knownObstacles;
  private final SortedMap<String, ItemPosition> waypoints;
  private final List<Runnable> listeners = new ArrayList<>();
  private final long knownFromNs;
  private long fixes;

  public Gps(Platform platform, Variables variables) {
    clock = platform.clock();
    knownObstacles = new KnownObstacles(platform.knownObstacles());
    variables.register(currentlocation);
    MotionParameters parameters = platform.motionParameters();
    assume(parameters);
    // Until then the wheels may still follow commands of an earlier start of this program.
    knownFromNs = clock.nowNs() + parameters.reactionMs() * NS_PER_MS;
    positioning = platform.positioning();
    waypoints = byName(platform.waypoints());
    positioning.onFix(this::fixed);
  }

  /** Whether a fix was accepted yet. */
  public boolean hasFix() {
    return filter.hasFix();
  }

  /** The current location: {@link Location.Unknown} before the first fix. */
  public Location location() {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? new Location.Unknown() : known;
  }

  /** {@link #location} as the gvh variable {@code currentlocation}. */
  public GvhVariable<Location> currentlocation() {
    return currentlocation;
  }

  /** The same variable under its name in the paper's Figure 3. */
  public GvhVariable<Location> mypos() {
    return currentlocation;
  }

  /**
   * The estimated pose.
   *
   * @throws IllegalStateException before the first fix
   */
  public Pose pose() {
    return known().pose();
  }

  /**
   * Bound of the distance between the true position and {@link #pose}, from the fixes' bounds and
   * the commands since the last one. Infinite before the first fix.
   */
  public double errorMm() {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? Double.POSITIVE_INFINITY : known.errorMm();
  }

  /** Age of the newest accepted fix; {@code Long.MAX_VALUE} before the first. */
  public long ageNs() {
    return hasFix() ? clock.nowNs() - filter.fixNs() : Long.MAX_VALUE;
  }

  /** Calls {@code listener} on the strand after each accepted fix. */
  public void onFix(Runnable listener) {
    listeners.add(listener);
  }

  /** States what a primitive needs at the start: {@link Positioning#require}. */
  public void require(StartNeeds needs) {
    positioning.require(needs);
  }

  /**
   * Whether a disc around this robot is certainly outside {@code zone}, border included: the
   * condition for releasing a zone. False before the first fix.
   */
  public boolean isClearOf(Region zone, double radiusMm) {
    return clearanceMm(zone, radiusMm) > 0;
  }

  /**
   * Lower bound of the distance between {@code zone} and a disc around this robot; below 0 if they
   * may overlap, minus infinity before the first fix.
   */
  public double clearanceMm(Region zone, double radiusMm) {
    Location.Known known = filter.at(clock.nowNs());
    if (zone instanceof Nowhere) {
      return Double.POSITIVE_INFINITY;
    }
    return known == null
        ? Double.NEGATIVE_INFINITY
        : zone.distanceMm(known.pose().at()) - known.errorMm() - radiusMm;
  }

  /**
   * Upper bound of the distance from this robot's centre to {@code point}; infinite before the
   * first fix.
   */
  public double maxDistanceMm(Point point) {
    Location.Known known = filter.at(clock.nowNs());
    return known == null
        ? Double.POSITIVE_INFINITY
        : known.pose().distanceMm(point) + known.errorMm();
  }

  /**
   * Lower bound of the distance from this robot's centre to {@code point}; 0 before the first fix.
   */
  public double minDistanceMm(Point point) {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? 0 : Math.max(0, known.pose().distanceMm(point) - known.errorMm());
  }

  /**
   * The newest fix of each robot that the positioning system has measured, this one included. A fix
   * is where that robot was at its time, within its error bounds: {@link Fix#timeNs}, on this
   * robot's clock, tells how old it is. A robot that crashed keeps its last fix. No message is sent.
   */
  public SortedMap<RobotId, Fix> getPositions() {
    return Collections.unmodifiableSortedMap(positioning.newest());
  }

  /** The newest fix of {@code robot}; null if the positioning system has never measured it. */
  public @Nullable Fix getPosition(RobotId robot) {
    return positioning.newest().get(robot);
  }

  /** The floor's waypoints, by name: the same on every robot; empty if there are none. */
  public SortedMap<String, ItemPosition> getWaypointPositions() {
    return waypoints;
  }

  /** The waypoint {@code name}; null if there is none. */
  public @Nullable ItemPosition getWaypointPosition(String name) {
    return waypoints.get(name);
  }

  private static SortedMap<String, ItemPosition> byName(List<ItemPosition> all) {
    SortedMap<String, ItemPosition> named = new TreeMap<>();
    all.forEach(waypoint -> named.put(waypoint.name(), waypoint));
    return Collections.unmodifiableSortedMap(named);
  }

  /** The obstacles that this robot knows. */
  public KnownObstacles knownObstacles() {
    return knownObstacles;
  }

  /** Number of fixes received. */
  public long fixes() {
    return fixes;
  }

  /**
   * Number of fixes that contradicted all earlier ones, in position or heading, and were not
   * accepted at once.
   */
  public long contradictions() {
    return filter.contradictions();
  }

  /**
   * Number of fixes not used because a newer one arrived before, or because their time is in the
   * future.
   */
  public long outdated() {
    return filter.outdated();
  }

  /** Whether the newest fixes contradict the commands since the earlier ones. */
  boolean isContradicted() {
    return filter.isContradicted();
  }

  /** From now on, assumes a body with these parameters. */
  void assume(MotionParameters parameters) {
    filter.assume(parameters.speedError(), parameters.reactionMs() * NS_PER_MS);
  }

  /** Records a wheel command, and whether a bump sensor is closed. */
  void commanded(WheelCommand command, boolean bumped) {
    filter.commanded(command, bumped, clock.nowNs());
  }

  /** The commands that may still be in effect if a new one is given now. */
  LingeringSpeeds lingering() {
    return filter.lingering(clock.nowNs());
  }

  private void fixed(Fix fix) {
    fixes++;
    if (fix.timeNs() >= knownFromNs && filter.fixed(fix, clock.nowNs())) {
      for (int i = 0; i < listeners.size(); i++) {
        listeners.get(i).run();
      }
    }
  }

  private Location.Known known() {
    Location.Known known = filter.at(clock.nowNs());
    if (known == null) {
      throw new IllegalStateException("no position fix yet: ask hasFix() first");
    }
    return known;
  }
}
