package org.starl.robot.contract;

final class StrandThatComputesSlowlyTest extends StrandContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround("compute(all,700us)", "drift(all,200ppm)");
  }
}
