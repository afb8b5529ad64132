package org.starl.robot.contract;

import org.starl.sim.fault.Impairment;

final class StrandThatComputesSlowlyTest extends StrandContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround(Impairment.ofTime(200, 0, 700_000));
  }
}
