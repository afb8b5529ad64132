package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayDeque;
import java.util.Iterator;
import org.jspecify.annotations.Nullable;

/**
 * Where a robot's wheels say that it has gone in the last second, by their odometry, in a frame of its
 * own. {@link PoseGate} judges the robot's fixes by it. From any thread.
 */
public final class WheelPath {

  /** Fixes are younger. */
  private static final long KEPT_NS = NS_PER_S;

  /** A body in contact may slide; and backing off it may touch what no bump sensor sees. */
  private static final long TOUCH_NS = 5 * NS_PER_S;

  /**
   * The odometry at one time.
   *
   * @param atNs its time; of the newest frame for times after that
   * @param stretch a number; between states of different numbers the body may have moved otherwise
   *     than its wheels: it had a contact, was lifted, or sensor frames are missing
   * @param pathMm length of the way so far, forward and backward
   * @param turnedRad sum of the turns so far, left and right
   */
  record State(
      long atNs,
      long stretch,
      double xMm,
      double yMm,
      double headingRad,
      double pathMm,
      double turnedRad,
      double mmPerS) {

    private State between(State next, long timeNs) {
      double part = (double) (timeNs - atNs) / (next.atNs - atNs);
      return new State(
          timeNs,
          Math.max(stretch, next.stretch),
          xMm + part * (next.xMm - xMm),
          yMm + part * (next.yMm - yMm),
          headingRad + part * (next.headingRad - headingRad),
          pathMm + part * (next.pathMm - pathMm),
          turnedRad + part * (next.turnedRad - turnedRad),
          mmPerS);
    }
  }

  private final double error;
  private final long lateNs;
  private final ArrayDeque<State> states = new ArrayDeque<>();
  private double forwardMm;
  private double turnRad;
  private boolean isBroken = true;
  private long touchedNs;
  private boolean hasTouched;
  private boolean isLifted;

  /**
   * @param error largest error of a way and of a turn, as a fraction of their lengths
   * @param lateNs sensor frames come so much after what they tell, at most
   */
  public WheelPath(double error, long lateNs) {
    this.error = error;
    this.lateNs = lateNs;
  }

  long lateNs() {
    return lateNs;
  }

  double error() {
    return error;
  }

  /** The next sensor frame is a new beginning: frames were lost. */
  public synchronized void lose() {
    isBroken = true;
  }

  /** From now on a person may carry the body, or it is on the floor again. */
  public synchronized void lift(boolean isUp) {
    isBroken |= isUp;
    isLifted = isUp;
  }

  synchronized boolean isLifted() {
    return isLifted;
  }

  /**
   * A sensor frame; times do not decrease.
   *
   * @param newForwardMm way since any beginning; backward is negative
   * @param newTurnRad turn since then, counter-clockwise
   * @param mmPerS the commanded speed of the faster wheel
   * @param isTouched whether a contact may move the body, too
   */
  public synchronized void add(
      long atNs, double newForwardMm, double newTurnRad, double mmPerS, boolean isTouched) {
    State last = states.peekLast();
    if (isTouched || isLifted) {
      hasTouched = true;
      touchedNs = atNs;
    }
    boolean isNew = isBroken || (hasTouched && atNs - touchedNs < TOUCH_NS);
    double wayMm = isBroken ? 0 : newForwardMm - forwardMm;
    double turn = isBroken ? 0 : newTurnRad - turnRad;
    forwardMm = newForwardMm;
    turnRad = newTurnRad;
    isBroken = false;
    if (last == null) {
      states.add(new State(atNs, 0, 0, 0, 0, 0, 0, mmPerS));
      return;
    }
    double middleRad = last.headingRad + turn / 2;
    states.add(
        new State(
            atNs,
            last.stretch + (isNew ? 1 : 0),
            last.xMm + wayMm * StrictMath.cos(middleRad),
            last.yMm + wayMm * StrictMath.sin(middleRad),
            last.headingRad + turn,
            last.pathMm + Math.abs(wayMm),
            last.turnedRad + Math.abs(turn),
            mmPerS));
    while (atNs - states.getFirst().atNs > KEPT_NS) {
      states.removeFirst();
    }
  }

  /** The greatest commanded speed of the last second. */
  synchronized double fastestMmPerS() {
    return states.stream().mapToDouble(State::mmPerS).max().orElse(0);
  }

  /** The state at a time, the newest one if that is not known yet; null before the first frame. */
  synchronized @Nullable State at(long timeNs) {
    State next = null;
    for (Iterator<State> newestFirst = states.descendingIterator(); newestFirst.hasNext(); ) {
      State state = newestFirst.next();
      if (state.atNs <= timeNs) {
        return next == null ? state : state.between(next, timeNs);
      }
      next = state;
    }
    return next;
  }
}
