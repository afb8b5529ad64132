package org.starl.motion;

import java.util.ArrayDeque;
import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/**
 * Wheels as bad as a motion may assume them to be: each command takes effect at any time within the
 * reaction, and is then carried out too fast, too slowly, or not at all, driving and turning each on
 * its own.
 */
final class Wheels {

  private record Pending(WheelCommand command, long fromNs) {}

  /** The parts of a command that are carried out, drawn anew so often. */
  private static final long CHANGE_NS = 30_000_000;

  private final double speedError;
  private final long reactionNs;
  private final Rng rng;
  private final ArrayDeque<Pending> pending = new ArrayDeque<>();
  private WheelCommand effective = WheelCommand.STOP;
  private double linearPart = 1;
  private double angularPart = 1;
  private long changeNs;

  /** How often, from 0 to 1, they do less than they are told. */
  double heldUp = 0.3;

  /** Of both driving and turning no more than this is carried out: 0 for stuck wheels. */
  double mobility = 1;

  Wheels(double speedError, long reactionNs, Rng rng) {
    this.speedError = speedError;
    this.reactionNs = reactionNs;
    this.rng = rng;
  }

  /** Told at {@code nowNs}; in effect somewhat later, but never before an earlier one. */
  void command(WheelCommand command, long nowNs) {
    long soonestNs = pending.isEmpty() ? nowNs : Math.max(nowNs, pending.getLast().fromNs);
    long lateNs = rng.nextBoolean(0.3) ? reactionNs : rng.nextLong(0, reactionNs);
    pending.add(new Pending(command, Math.max(soonestNs, nowNs + lateNs)));
  }

  /** Where the body gets from one time to a later one. */
  Pose drive(Pose from, long nowNs, long untilNs) {
    Pose at = from;
    long sinceNs = nowNs;
    while (sinceNs < untilNs) {
      Pending next = pending.peek();
      if (next != null && next.fromNs <= sinceNs) {
        effective = next.command;
        pending.remove();
        continue;
      }
      if (changeNs <= sinceNs) {
        linearPart = drawPart();
        angularPart = drawPart();
        changeNs = sinceNs + CHANGE_NS;
      }
      long toNs = Math.min(untilNs, changeNs);
      toNs = next == null ? toNs : Math.min(toNs, next.fromNs);
      at =
          Kinematics.after(
              at,
              effective.linearMmPerS() * linearPart,
              effective.angularRadPerS() * angularPart,
              (toNs - sinceNs) / 1e9);
      sinceNs = toNs;
    }
    return at;
  }

  /** What the body does now, of driving; for a wall that stops it. */
  WheelCommand effective() {
    return effective;
  }

  private double drawPart() {
    if (rng.nextBoolean(heldUp)) {
      return mobility * rng.nextDouble();
    }
    double off = rng.nextBoolean(0.5) ? 1 : 2 * rng.nextDouble() - 1;
    return mobility * (1 + speedError * off);
  }
}
