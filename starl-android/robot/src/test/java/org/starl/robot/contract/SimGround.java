package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.starl.platform.Clock;
import org.starl.platform.Timers;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.kernel.RobotError;
import org.starl.sim.kernel.SimStrand;

/** A simulated strand in a kernel. */
public final class SimGround implements Ground {

  private final Kernel kernel;
  private final SimStrand strand;
  private final List<Throwable> errors;

  public SimGround(CarrierKind kind) {
    this(new Kernel(kind), "robot0", new ArrayList<>());
  }

  private SimGround(Kernel kernel, String name, List<Throwable> errors) {
    this.kernel = kernel;
    this.strand = kernel.strand(name);
    this.errors = errors;
  }

  /** Another robot of the same kernel. */
  public SimGround neighbour(String name) {
    return new SimGround(kernel, name, errors);
  }

  public Kernel kernel() {
    return kernel;
  }

  @Override
  public Clock clock() {
    return kernel;
  }

  @Override
  public SimStrand strand() {
    return strand;
  }

  @Override
  public Timers timers() {
    return strand;
  }

  @Override
  public void closeStrand() {
    ending(strand::close);
  }

  @Override
  public void runUntil(CountDownLatch done) {
    ending(() -> kernel.run(3_600_000_000_000L, () -> done.getCount() == 0));
    assertThat(done.getCount()).as("done; errors " + errors).isZero();
  }

  @Override
  public void runUntilError() {
    ending(() -> kernel.run(3_600_000_000_000L, () -> false));
    assertThat(errors).isNotEmpty();
  }

  @Override
  public List<Throwable> errors() {
    return errors;
  }

  @Override
  public void close() {
    ending(kernel::close);
  }

  private void ending(Runnable run) {
    try {
      run.run();
    } catch (RobotError e) {
      errors.add(e.getCause());
    }
  }
}
