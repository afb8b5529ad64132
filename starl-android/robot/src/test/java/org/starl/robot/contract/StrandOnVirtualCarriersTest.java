package org.starl.robot.contract;

import org.starl.sim.kernel.CarrierKind;

class StrandOnVirtualCarriersTest extends StrandContract {

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.VIRTUAL);
  }
}
