package org.starl.robot.contract;

import org.starl.platform.Stable;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.SimStable;

class SimStableTest extends StableContract {

  private SimStable stable;

  @Override
  protected Ground newGround() {
    return new SimGround(CarrierKind.VIRTUAL);
  }

  @Override
  protected Stable open(Ground ground) {
    stable = new SimStable(ground.clock(), 5_000_000);
    return crashAndReopen(ground);
  }

  @Override
  protected Stable crashAndReopen(Ground ground) {
    stable.restart(ground.timers());
    return stable;
  }
}
