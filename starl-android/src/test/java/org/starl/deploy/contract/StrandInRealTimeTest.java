package org.starl.deploy.contract;

class StrandInRealTimeTest extends StrandContract {

  @Override
  protected Ground newGround() {
    return new RealGround("robot0");
  }
}
