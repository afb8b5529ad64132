package org.starl.robot.contract;

final class TimersThatComputesSlowlyTest extends TimersContract {
  @Override
  protected Ground newGround() {
    return new ImpairedGround("compute(all,700us)", "drift(all,200ppm)");
  }
}
