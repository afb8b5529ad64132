package org.starl.robot.contract;

import org.starl.platform.Background;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.SimBackground;

class BackgroundOnPlatformCarriersTest extends BackgroundContract {

  @Override
  protected SimGround newGround() {
    return new SimGround(CarrierKind.PLATFORM);
  }

  @Override
  protected Background newBackground(Ground on) {
    SimGround ground = (SimGround) on;
    return new SimBackground(ground.kernel(), ground.strand(), 5_000_000);
  }
}
