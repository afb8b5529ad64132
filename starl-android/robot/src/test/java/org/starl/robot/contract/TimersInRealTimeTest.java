package org.starl.robot.contract;

class TimersInRealTimeTest extends TimersContract {

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }
}
