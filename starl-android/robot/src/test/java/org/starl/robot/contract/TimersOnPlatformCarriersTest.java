package org.starl.robot.contract;

import org.starl.sim.kernel.CarrierKind;

class TimersOnPlatformCarriersTest extends TimersContract {

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.PLATFORM);
  }
}
