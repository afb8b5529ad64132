package org.starl.deploy.contract;

class TimersInRealTimeTest extends TimersContract {

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }
}
