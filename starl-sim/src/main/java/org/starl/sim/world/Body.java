package org.starl.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Pose;
import org.starl.geometry.Sines;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.time.Time;

/**
 * A robot's true body in the {@link World}: a disc that drives. Its <em>budget</em> is the distance
 * that it may still drive before the world must check it again, see {@link Collider}.
 */
public final class Body {

  /** The number of a body without one. */
  public static final int NO_NUMBER = -1;

  static final long NEVER = Long.MAX_VALUE;

  static final double LONGEST_NS = 1e18;

  private final World world;
  private final RobotId id;
  private final double radiusMm;
  private final int number;
  private final Timer timer;
  private long timerNs = NEVER;
  private boolean gone;

  // The commanded speeds, within the world's limits.
  double wantedMmPerS;
  double wantedRadPerS;

  // The true speeds since anchorNs.
  private long anchorNs;
  private double anchorXMm;
  private double anchorYMm;
  private double anchorRad;
  private double cosine;
  private double sine;
  private double mmPerS;
  private double radPerS;

  // The pose at cachedNs.
  private long cachedNs;
  private double xMm;
  private double yMm;
  private double headingRad;

  private double budgetMm;
  private long budgetNs;
  long dueNs = NEVER;

  final List<Body> touchedBodies = new ArrayList<>(0);
  final List<Wall> touchedWalls = new ArrayList<>(0);
  private Bumps bumps = Bumps.NONE;
  private Runnable bumpReceiver = () -> {};

  // Links of the list of bodies in a bucket of the world's grid.
  int cellX;
  int cellY;
  @Nullable Body nextInBucket;
  @Nullable Body previousInBucket;

  Body(World world, RobotId id, Pose pose, double radiusMm, int number, long nowNs) {
    this.world = world;
    this.id = id;
    this.radiusMm = radiusMm;
    this.number = number;
    this.timer = world.timer(this::expired);
    anchorNs = nowNs;
    anchorXMm = pose.xMm();
    anchorYMm = pose.yMm();
    anchorRad = Angles.normalize(pose.headingRad());
    cosine = Sines.cos(anchorRad);
    sine = Sines.sin(anchorRad);
    cachedNs = nowNs;
    xMm = anchorXMm;
    yMm = anchorYMm;
    headingRad = anchorRad;
    budgetNs = nowNs;
  }

  public RobotId id() {
    return id;
  }

  public double radiusMm() {
    return radiusMm;
  }

  /** The number that the run gave it; {@link #NO_NUMBER} if none. */
  public int number() {
    return number;
  }

  /** The true pose now. */
  public Pose pose() {
    moveTo(world.nowNs());
    return new Pose(xMm, yMm, headingRad);
  }

  /** True forward speed now: 0 while blocked. */
  public double linearMmPerS() {
    return mmPerS;
  }

  /** True turning speed now. */
  public double angularRadPerS() {
    return radPerS;
  }

  /** Whether the body presses against a contact and therefore does not advance. */
  public boolean isBlocked() {
    return wantedMmPerS != 0 && mmPerS == 0;
  }

  /** The bodies and walls that it touches, in words; empty if none. */
  public List<String> touches() {
    List<String> names = new ArrayList<>();
    touchedBodies.forEach(other -> names.add(other.id().name()));
    touchedWalls.forEach(wall -> names.add("a wall at " + wall.nearestTo(xMm, yMm)));
    return names;
  }

  /** The state of the bump sensors on its front half. */
  public Bumps bumps() {
    return bumps;
  }

  /**
   * Sets the only listener to changes of {@link #bumps}. It is called inside a step of the world,
   * and must only store data or schedule an event.
   */
  public void onBump(Runnable receiver) {
    bumpReceiver = receiver;
  }

  /**
   * Drives at these speeds from now on, limited by the world's limits.
   *
   * @throws IllegalStateException if the body was removed from the world
   */
  public void drive(WheelCommand command) {
    if (gone) {
      throw new IllegalStateException(id + " drives, but has left the world");
    }
    world.drive(this, command);
  }

  double xMm() {
    return xMm;
  }

  double yMm() {
    return yMm;
  }

  double headingRad() {
    return headingRad;
  }

  /** Updates {@link #xMm}, {@link #yMm} and {@link #headingRad} to {@code nowNs}. */
  void moveTo(long nowNs) {
    if (nowNs == cachedNs) {
      return;
    }
    cachedNs = nowNs;
    if (mmPerS == 0 && radPerS == 0) {
      return;
    }
    double seconds = Time.seconds(nowNs - anchorNs);
    double turn = radPerS * seconds;
    double chordMm = Kinematics.chordMm(mmPerS, turn, seconds);
    headingRad = Angles.normalize(anchorRad + turn);
    if (radPerS == 0) {
      xMm = anchorXMm + chordMm * cosine;
      yMm = anchorYMm + chordMm * sine;
    } else if (mmPerS != 0) {
      double direction = anchorRad + turn / 2;
      xMm = anchorXMm + chordMm * Sines.cos(direction);
      yMm = anchorYMm + chordMm * Sines.sin(direction);
    }
  }

  /**
   * Sets the true speeds from {@code nowNs}, the time of the last {@link #moveTo}. Returns whether
   * they changed.
   */
  boolean setMotion(long nowNs, double newMmPerS, double newRadPerS) {
    if (newMmPerS == mmPerS && newRadPerS == radPerS) {
      return false;
    }
    spendBudget(nowNs);
    if (headingRad != anchorRad) {
      cosine = Sines.cos(headingRad);
      sine = Sines.sin(headingRad);
    }
    anchorNs = nowNs;
    anchorXMm = xMm;
    anchorYMm = yMm;
    anchorRad = headingRad;
    mmPerS = newMmPerS;
    radPerS = newRadPerS;
    return true;
  }

  double speedMmPerS() {
    return Math.abs(mmPerS);
  }

  /** The budget left at {@code nowNs}, in mm. */
  double budgetMm(long nowNs) {
    spendBudget(nowNs);
    return budgetMm;
  }

  void setBudgetMm(long nowNs, double newBudgetMm) {
    budgetMm = newBudgetMm;
    budgetNs = nowNs;
  }

  private void spendBudget(long nowNs) {
    if (nowNs != budgetNs) {
      budgetMm = Math.max(0, budgetMm - speedMmPerS() * Time.seconds(nowNs - budgetNs));
      budgetNs = nowNs;
    }
  }

  /** The time at which the budget is spent at the current speeds; never in the past. */
  long spentNs() {
    double ns = budgetMm / speedMmPerS() * Time.NS_PER_S;
    return mmPerS == 0 || ns > LONGEST_NS ? NEVER : budgetNs + (long) ns;
  }

  /**
   * Requests a check at {@code newDueNs}. An earlier pending timer is kept: commands change often,
   * and setting the timer costs more than an occasional needless expiry.
   */
  void setDue(long newDueNs) {
    dueNs = newDueNs;
    if (newDueNs < timerNs) {
      timerNs = newDueNs;
      timer.set(newDueNs);
    }
  }

  private void expired() {
    timerNs = NEVER;
    if (dueNs <= world.nowNs()) {
      world.check(this);
    } else if (dueNs != NEVER) {
      setDue(dueNs);
    }
  }

  void setBumps(Bumps newBumps) {
    if (newBumps != bumps) {
      bumps = newBumps;
      bumpReceiver.run();
    }
  }

  boolean isTouching() {
    return !touchedBodies.isEmpty() || !touchedWalls.isEmpty();
  }

  void leave() {
    gone = true;
    timer.cancel();
    dueNs = NEVER;
    bumpReceiver = () -> {};
  }

  @Override
  public String toString() {
    return id + " at " + xMm + ", " + yMm;
  }
}
