package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.util.EnumSet;
import java.util.Set;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/**
 * The program's side of any drive: its command, and the reasons to hold the wheels that do not depend
 * on the robot's model. Pure; times never decrease; one thread at a time.
 */
public final class DriveGate {

  private final long commandTimeoutMs;
  private final long positionTimeoutMs;
  private WheelCommand wanted = WheelCommand.STOP;
  private long wantedNs = Long.MIN_VALUE;
  private long lastFixNs = Long.MIN_VALUE;
  private long doubtedNs = Long.MIN_VALUE;
  private boolean isEmergency;
  private Bumps bumps = Bumps.NONE;
  private Bumps reportedBumps = Bumps.NONE;
  private Bumps pendingBumps = Bumps.NONE;
  private boolean isBumpPending;

  /**
   * @param commandTimeoutMs the wheels stop if the command was not repeated for this time
   * @param positionTimeoutMs the wheels stop if the last fix is older; 0: fixes are not checked
   */
  public DriveGate(long commandTimeoutMs, long positionTimeoutMs) {
    this.commandTimeoutMs = commandTimeoutMs;
    this.positionTimeoutMs = positionTimeoutMs;
  }

  /** The program's command; ignored if the program has not been informed of a bump yet. */
  public void drive(WheelCommand command, long atNs) {
    if (!isBumpPending) {
      wanted = command;
      wantedNs = atNs;
    }
  }

  /** A fix that was measured at {@code fixNs}. */
  public void fixed(long fixNs, long atNs) {
    if (fixNs > doubtedNs) {
      lastFixNs = Math.max(lastFixNs, Math.min(fixNs, atNs));
    }
  }

  /** Only a fix that is measured from now on counts: another thread may still pass an older one. */
  public void doubted(long atNs) {
    lastFixNs = Long.MIN_VALUE;
    doubtedNs = atNs;
  }

  /** Begins or ends an emergency stop. */
  public void emergencyStop(boolean isOn) {
    isEmergency = isOn;
    if (isOn) {
      wanted = WheelCommand.STOP;
    }
  }

  /** The bump sensors' new state. */
  public void bumped(Bumps now) {
    boolean hasNew = !union(bumps, now).equals(bumps);
    bumps = now;
    if (hasNew) {
      // The program gave its last command without knowing of this bump.
      isBumpPending = true;
      wanted = WheelCommand.STOP;
      pendingBumps = union(pendingBumps, now);
    } else if (!isBumpPending) {
      pendingBumps = now;
    }
  }

  /** Whether the strand must be informed about bumps. */
  public boolean mustInform() {
    return isBumpPending || pendingBumps != reportedBumps;
  }

  /** Informs the strand; returns the bumps that it sees until the next call. */
  public Bumps inform() {
    reportedBumps = pendingBumps;
    isBumpPending = false;
    pendingBumps = bumps;
    return reportedBumps;
  }

  /** The reasons on the program's side that hold the wheels. */
  public Set<CreateHold> holds(long nowNs) {
    // A program need not repeat the command to stop.
    boolean isDriving = !wanted.isStop();
    Set<CreateHold> holds = EnumSet.noneOf(CreateHold.class);
    add(holds, isEmergency, CreateHold.EMERGENCY_STOP);
    add(holds, isBumpPending, CreateHold.BUMP_UNTOLD);
    add(holds, isDriving && !isWithin(nowNs, wantedNs, commandTimeoutMs), CreateHold.STALE_COMMAND);
    add(
        holds,
        isDriving && positionTimeoutMs > 0 && !isWithin(nowNs, lastFixNs, positionTimeoutMs),
        CreateHold.STALE_POSITION);
    add(holds, bumps.any(), CreateHold.BUMP);
    return holds;
  }

  /** The program's command, limited by {@code holds} and by the greatest speed of a wheel. */
  public WheelCommand allowed(Set<CreateHold> holds, double axleMm, double maxWheelMmPerS) {
    WheelCommand left = WheelLimit.under(holds, wanted);
    double factor = WheelLimit.factor(left, axleMm, maxWheelMmPerS);
    return factor == 1
        ? left
        : new WheelCommand(left.linearMmPerS() * factor, left.angularRadPerS() * factor);
  }

  /** Adds {@code hold} if {@code isOn}. */
  public static void add(Set<CreateHold> holds, boolean isOn, CreateHold hold) {
    if (isOn) {
      holds.add(hold);
    }
  }

  static boolean isWithin(long nowNs, long sinceNs, long ms) {
    return sinceNs != Long.MIN_VALUE && nowNs - sinceNs <= ms * NS_PER_MS;
  }

  private static Bumps union(Bumps one, Bumps other) {
    return one == other || other == Bumps.NONE ? one : one == Bumps.NONE ? other : Bumps.BOTH;
  }
}
