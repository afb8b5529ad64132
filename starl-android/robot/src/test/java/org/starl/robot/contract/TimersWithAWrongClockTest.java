package org.starl.robot.contract;

import org.starl.sim.fault.Impairment;
import org.starl.time.Time;

final class TimersWithAWrongClockTest extends TimersContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround(Impairment.ofTime(-70_000, 50 * Time.NS_PER_MS, 0));
  }
}
