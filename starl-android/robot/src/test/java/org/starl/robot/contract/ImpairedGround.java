package org.starl.robot.contract;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.Timers;
import org.starl.sim.fault.ImpairedStrand;
import org.starl.sim.fault.Impairment;
import org.starl.sim.fault.RobotClock;
import org.starl.sim.kernel.CarrierKind;

/** A simulated strand whose clock is wrong and on which computing takes time. */
final class ImpairedGround implements Ground {

  private final SimGround sound = new SimGround(CarrierKind.best());
  private final RobotClock clock = new RobotClock(sound.kernel());
  private final ImpairedStrand strand = new ImpairedStrand(sound.strand(), clock, sound.kernel());

  ImpairedGround(Impairment impairment) {
    strand.apply(impairment);
  }

  @Override
  public Clock clock() {
    return clock;
  }

  @Override
  public Strand strand() {
    return strand;
  }

  @Override
  public Timers timers() {
    return strand;
  }

  @Override
  public void closeStrand() {
    sound.closeStrand();
  }

  @Override
  public void runUntil(CountDownLatch done) {
    sound.runUntil(done);
  }

  @Override
  public void runUntilError() {
    sound.runUntilError();
  }

  @Override
  public List<Throwable> errors() {
    return sound.errors();
  }

  @Override
  public void close() {
    sound.close();
  }
}
