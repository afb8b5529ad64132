package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.starl.platform.Clock;
import org.starl.platform.Timers;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;

/** A real strand in real time. */
public final class RealGround implements Ground {

  private final List<Throwable> errors = new CopyOnWriteArrayList<>();
  private final CountDownLatch failed = new CountDownLatch(1);
  private final Clock clock = new RealClock();
  private final RealStrand strand;

  public RealGround(String name) {
    strand = new RealStrand(name, clock, this::failed);
  }

  @Override
  public Clock clock() {
    return clock;
  }

  @Override
  public RealStrand strand() {
    return strand;
  }

  @Override
  public Timers timers() {
    return strand;
  }

  @Override
  public void closeStrand() {
    strand.close();
  }

  @Override
  public void runUntil(CountDownLatch done) {
    try {
      assertThat(done.await(60, TimeUnit.SECONDS)).as("done, or " + errors).isTrue();
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    }
  }

  @Override
  public void runUntilError() {
    runUntil(failed);
  }

  @Override
  public List<Throwable> errors() {
    return errors;
  }

  @Override
  public void close() {
    strand.close();
  }

  private void failed(Throwable error) {
    errors.add(error);
    failed.countDown();
  }
}
