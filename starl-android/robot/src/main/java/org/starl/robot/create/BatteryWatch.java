package org.starl.robot.create;

import org.jspecify.annotations.Nullable;

/** Lines about a battery that runs low: each level once, until it has been charged. */
final class BatteryWatch {

  private static final int FAULT = 5;
  private static final int LOW_PERCENT = 20;
  private static final int EMPTY_PERCENT = 5;
  private static final int CHARGED_PERCENT = 30;

  private int warnedPercent = 100;
  private boolean isFaulty;

  /** A line if there is something new to say. */
  @Nullable String update(CreateSensors sensors) {
    boolean wasFaulty = isFaulty;
    isFaulty = sensors.chargingState() == FAULT;
    if (isFaulty && !wasFaulty) {
      return "charging fault";
    }
    if (sensors.capacityMah() <= 0) {
      return null;
    }
    int percent = 100 * sensors.chargeMah() / sensors.capacityMah();
    if (percent >= CHARGED_PERCENT) {
      warnedPercent = 100;
    }
    int level = percent <= EMPTY_PERCENT ? EMPTY_PERCENT : LOW_PERCENT;
    if (percent > level || warnedPercent <= level) {
      return null;
    }
    warnedPercent = level;
    return (level == EMPTY_PERCENT ? "battery almost empty: " : "battery low: ")
        + sensors.chargeMah()
        + " of "
        + sensors.capacityMah()
        + " mAh";
  }
}
