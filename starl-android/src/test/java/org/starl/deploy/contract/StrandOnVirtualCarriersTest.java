package org.starl.deploy.contract;

import org.starl.sim.kernel.CarrierKind;

class StrandOnVirtualCarriersTest extends StrandContract {

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.VIRTUAL);
  }
}
