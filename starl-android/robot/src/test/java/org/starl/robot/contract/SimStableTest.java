package org.starl.robot.contract;

import org.starl.platform.StableStorage;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.SimStable;

class SimStableTest extends StableContract {

  private SimStable stable;

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.VIRTUAL);
  }

  @Override
  protected StableStorage open(Ground ground) {
    stable = new SimStable(ground.clock(), 5_000_000);
    return crashAndReopen(ground);
  }

  @Override
  protected StableStorage crashAndReopen(Ground ground) {
    stable.restart(ground.timers());
    return stable;
  }
}
