package org.starl.robot.contract;

import org.starl.sim.kernel.CarrierKind;

class StrandOnPlatformCarriersTest extends StrandContract {

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.PLATFORM);
  }
}
