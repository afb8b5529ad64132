package org.starl.robot.contract;

import org.starl.sim.kernel.CarrierKind;

class TimersOnVirtualCarriersTest extends TimersContract {

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.VIRTUAL);
  }
}
