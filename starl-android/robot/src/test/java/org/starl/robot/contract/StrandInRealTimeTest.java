package org.starl.robot.contract;

class StrandInRealTimeTest extends StrandContract {

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }
}
