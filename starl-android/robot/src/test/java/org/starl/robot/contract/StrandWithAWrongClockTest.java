package org.starl.robot.contract;

final class StrandWithAWrongClockTest extends StrandContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround("drift(all,-70000ppm)", "skew(all,50ms)");
  }
}
