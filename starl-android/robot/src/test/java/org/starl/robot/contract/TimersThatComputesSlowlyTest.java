package org.starl.robot.contract;

import org.starl.sim.fault.Impairment;

final class TimersThatComputesSlowlyTest extends TimersContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround(Impairment.ofTime(200, 0, 700_000));
  }
}
