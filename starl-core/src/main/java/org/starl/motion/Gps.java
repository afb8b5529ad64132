package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Trace;
import org.starl.platform.Clock;
import org.starl.platform.Platform;

/**
 * {@code gvh.gps}: where this robot is, filtered from the fixes of its positioning system and from
 * what its wheels are told (paper, section 5.1). Strand only.
 *
 * <p>Every position comes with a bound that holds for certain as long as each fix's own bound does
 * and the body follows its commands as {@link MotionParameters} states: {@code speedError}, {@code
 * reactionMs}; see {@link #errorMm}. A fix that contradicts all before is counted and not believed,
 * and until one fits again the bound holds its place as well. Millimetres, radians counter-clockwise,
 * on the robot's own clock.
 */
public final class Gps {

  private final Clock clock;
  private final Trace trace;
  private final PositionFilter filter = new PositionFilter();
  private final LocationVariable currentlocation = new LocationVariable(this);
  private final KnownObstacles knownObstacles;
  private final List<Runnable> listeners = new ArrayList<>();
  private final long knownFromNs;
  private boolean tracesFixes;
  private long fixes;

  public Gps(GlobalVarHolder gvh, Platform platform) {
    clock = platform.clock();
    trace = gvh.trace;
    knownObstacles = new KnownObstacles(platform.knownObstacles());
    gvh.register(currentlocation);
    MotionParameters parameters = platform.motionParameters();
    assume(parameters);
    // Until then the wheels may follow what an earlier start of this program had told them.
    knownFromNs = clock.nowNs() + parameters.reactionMs() * NS_PER_MS;
    platform.positioning().onFix(this::fixed);
  }

  /** Whether there was any fix yet. */
  public boolean hasFix() {
    return filter.hasFix();
  }

  /** All that is known now: {@link Location.Unknown} before the first fix. */
  public Location location() {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? new Location.Unknown() : known;
  }

  /** {@link #location} as the gvh's variable {@code currentlocation}. */
  public GvhVariable<Location> currentlocation() {
    return currentlocation;
  }

  /** The same under the name that it has in the paper's Figure 3. */
  public GvhVariable<Location> mypos() {
    return currentlocation;
  }

  /**
   * Where the robot is now, as far as it knows.
   *
   * @throws IllegalStateException without any fix yet
   */
  public Pose pose() {
    return known().pose();
  }

  /**
   * The true position lies within this distance of {@link #pose}: the fixes' bounds, and whatever
   * the wheels were told since the last one. Infinite without any fix yet.
   */
  public double errorMm() {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? Double.POSITIVE_INFINITY : known.errorMm();
  }

  /** Age of the newest fix that was believed; {@code Long.MAX_VALUE} without any. */
  public long ageNs() {
    return hasFix() ? clock.nowNs() - filter.fixNs() : Long.MAX_VALUE;
  }

  /** Calls {@code listener} on the strand after each fix that was believed. */
  public void onFix(Runnable listener) {
    listeners.add(listener);
  }

  /** Whether each fix writes {@code currentlocation} to the trace; at first it does not. */
  public void traceFixes(boolean on) {
    tracesFixes = on;
  }

  /**
   * Whether a disc around this robot is outside {@code zone} for certain, border included: what
   * has to hold before a zone is given back. False without a fix.
   */
  public boolean isClearOf(Region zone, double radiusMm) {
    return clearanceMm(zone, radiusMm) > 0;
  }

  /**
   * A disc around this robot is at least this far from {@code zone}; below 0 if that is not certain
   * even of a touch, minus infinity without a fix.
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

  /** Whether this robot's centre is in {@code area} for certain. False without a fix. */
  public boolean isSurelyIn(Region area) {
    Location.Known known = filter.at(clock.nowNs());
    return known != null && area.depthMm(known.pose().at()) > known.errorMm();
  }

  /** This robot's centre is at most this far from {@code point}; infinite without a fix. */
  public double farthestMm(Point point) {
    Location.Known known = filter.at(clock.nowNs());
    return known == null
        ? Double.POSITIVE_INFINITY
        : known.pose().distanceMm(point) + known.errorMm();
  }

  /** This robot's centre is at least this far from {@code point}; 0 without a fix. */
  public double nearestMm(Point point) {
    Location.Known known = filter.at(clock.nowNs());
    return known == null ? 0 : Math.max(0, known.pose().distanceMm(point) - known.errorMm());
  }

  /** The obstacles that this robot believes in. */
  public KnownObstacles knownObstacles() {
    return knownObstacles;
  }

  /** Fixes received. */
  public long fixes() {
    return fixes;
  }

  /** Fixes that contradicted all before, in position or heading, and were not believed at once. */
  public long contradictions() {
    return filter.contradictions();
  }

  /** Fixes not used because a newer one was there before, or because they come from the future. */
  public long outdated() {
    return filter.outdated();
  }

  /** The body is one that these parameters speak of, from now on. */
  void assume(MotionParameters parameters) {
    filter.assume(parameters.speedError(), parameters.reactionMs() * NS_PER_MS);
  }

  /** The wheels are told this now, while a bump sensor is closed or not. */
  void commanded(WheelCommand command, boolean bumped) {
    filter.commanded(command, bumped, clock.nowNs());
  }

  /** What the wheels may go on doing when they are told something else now. */
  Lingering lingering() {
    return filter.lingering(clock.nowNs());
  }

  private void fixed(Fix fix) {
    fixes++;
    boolean believed = fix.timeNs() >= knownFromNs && filter.fixed(fix, clock.nowNs());
    if (tracesFixes && trace.isOn()) {
      trace.variable(currentlocation.source(), currentlocation.name(), location());
    }
    if (believed) {
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
