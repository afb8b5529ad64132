package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.robot.create.CreateHold;
import org.starl.robot.create.DriveGate;
import org.starl.robot.file.Limits;

/** What a base does and may do: messages and times in, speeds out. Pure; times never decrease. */
final class BaseState {

  private final Limits limits;
  private final double axleMm;
  private final DriveGate gate;
  private Contacts contacts = Contacts.NONE;
  private long odometryNs = Long.MIN_VALUE;
  private boolean isReceived;
  private boolean isSilenceTold;
  private boolean isSpeedTold;

  BaseState(Limits limits, double axleMm) {
    this.limits = limits;
    this.axleMm = axleMm;
    gate = new DriveGate(limits.watchdogMs(), limits.positionMs());
  }

  DriveGate gate() {
    return gate;
  }

  /** Whether the guard runs and a node receives its speeds. */
  void received(boolean isOn) {
    isReceived = isOn;
  }

  void contacts(Contacts now) {
    contacts = now;
    gate.bumped(now.bumps());
  }

  /** Returns a line if the base drives faster than its limit allows: once, until it is slow again. */
  @Nullable String odometry(Messages.Odometry odometry, long nowNs) {
    odometryNs = nowNs;
    WheelCommand now = new WheelCommand(odometry.linearMmPerS(), odometry.angularRadPerS());
    double fastest = now.fastestMmPerS(axleMm);
    boolean wasTold = isSpeedTold;
    isSpeedTold = fastest > (1 + limits.speedError()) * limits.speedMmPerS();
    return isSpeedTold && !wasTold
        ? "a wheel turns at "
            + Math.round(fastest)
            + " mm/s, faster than limits.speedMmPerS and limits.speedError allow"
        : null;
  }

  /** Everything that holds the wheels, worst first. */
  Set<CreateHold> holds(long nowNs) {
    Set<CreateHold> holds = gate.holds(nowNs);
    DriveGate.add(holds, !isReceived, CreateHold.NO_LINK);
    DriveGate.add(holds, isReceived && isSilent(nowNs), CreateHold.NO_SENSORS);
    DriveGate.add(holds, contacts.wheelDrop(), CreateHold.WHEEL_DROP);
    DriveGate.add(holds, contacts.cliff(), CreateHold.CLIFF);
    return holds;
  }

  /** The speeds that the base may have now. */
  WheelCommand speeds(long nowNs) {
    return gate.allowed(holds(nowNs), axleMm, limits.speedMmPerS());
  }

  /** A line for each new cause that is worth one. */
  List<String> news(Set<CreateHold> before, long nowNs, String odometryTopic) {
    boolean isSilent = odometryNs != Long.MIN_VALUE && isSilent(nowNs);
    boolean isNewSilence = isSilent && !isSilenceTold;
    boolean isEnd = !isSilent && isSilenceTold;
    isSilenceTold = isSilent;
    Set<CreateHold> now = holds(nowNs);
    boolean isLate =
        now.contains(CreateHold.STALE_COMMAND) && !before.contains(CreateHold.STALE_COMMAND);
    boolean isLost =
        now.contains(CreateHold.STALE_POSITION) && !before.contains(CreateHold.STALE_POSITION);
    List<String> news = new ArrayList<>();
    if (isNewSilence) {
      news.add(odometryTopic + ": no message for " + limits.positionMs() + " ms: wheels stopped");
    }
    if (isEnd) {
      news.add(odometryTopic + ": messages again");
    }
    if (isLate) {
      news.add("no command for " + limits.watchdogMs() + " ms: wheels stopped");
    }
    if (isLost) {
      news.add("no fix for " + limits.positionMs() + " ms: wheels stopped");
    }
    return news;
  }

  Bumps bumps() {
    return contacts.bumps();
  }

  boolean isLifted() {
    return contacts.wheelDrop();
  }

  private boolean isSilent(long nowNs) {
    return odometryNs == Long.MIN_VALUE || nowNs - odometryNs > limits.positionMs() * NS_PER_MS;
  }
}
