package org.starl.workload;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.barrier.BarrierSettings;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/**
 * {@code starl campaign barrier}: those who are registered meet, generation after generation, in a
 * barrier of each view. Who restarts, or was left out, registers anew, and there is another barrier.
 * Who has done all its rounds stays registered, to vote for those who have not; they are told that it
 * did not come, and go on without it.
 */
final class BarrierWorkload extends PrimitiveDemo {

  private static final String XID = "yard";
  private static final long THINK_MS = 500;
  private static final long DEADLINE_MS = 10_000;
  private static final long NS_PER_MS = 1_000_000;

  BarrierWorkload() {
    super("barrier", "robots meet again and again, whoever of them is registered");
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(10), busy("20s"));
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    long withinNs = Bounds.withinNs(settings);
    RegistrationSettings how =
        RegistrationSettings.DEFAULT.withDeadlineMs(Bounds.deadlineMs(withinNs));
    place(simulation, settings, count(request, 1, 32), gvh -> new Guest(gvh, course, how));
    simulation.monitor(() -> new RegistrationSpec(withinNs));
    // By a clock that is slow by a tenth and was put back by a second, the deadlines are later.
    long toldNs = (2 * DEADLINE_MS + DEADLINE_MS / 4 + 1_000) * NS_PER_MS;
    simulation.monitor(() -> new BarrierSpec(withinNs, toldNs));
  }

  private static final class Guest extends Client {
    private final Registration reg;
    private final Map<Long, Barrier> barriers = new TreeMap<>();

    Guest(GlobalVarHolder gvh, Course course, RegistrationSettings settings) {
      super(gvh, course, THINK_MS);
      reg = registration(XID, settings);
    }

    @Override
    protected void prepare() {
      while (!reg.mayRequest()) {
        reg.do_register();
        await(() -> reg.mayRequest() || reg.failed().get());
      }
    }

    @Override
    protected boolean obtain(int round) {
      long view = reg.ts();
      Barrier barrier = barriers.computeIfAbsent(view, any -> barrier());
      barrier.arrive();
      await(() -> barrier.outcome().get().isTold() || reg.ts() > view || !reg.mayRequest());
      BarrierOutcome outcome = barrier.outcome().get();
      if (outcome instanceof BarrierOutcome.Excluded) {
        unregister(); // and so come back by way of another view
      }
      return outcome instanceof BarrierOutcome.Passed;
    }

    private Barrier barrier() {
      BarrierSettings settings = BarrierSettings.DEFAULT.withDeadlineMs(DEADLINE_MS);
      return new Barrier(gvh, XID, reg, settings);
    }

    private void unregister() {
      while (!reg.isUnregistered()) {
        reg.unregister();
        await(() -> reg.isUnregistered() || reg.failed().get());
      }
    }
  }
}
