package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** {@code starl campaign registration}: robots register, stay a while, and unregister. */
final class RegistrationWorkload extends PrimitiveDemo {

  private static final long THINK_MS = 500;
  private static final long STAY_MS = 1_000;

  RegistrationWorkload() {
    super("registration", "robots register, stay a while, and unregister, again and again");
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
    place(simulation, settings, count(request, 1, 32), gvh -> new Member(gvh, course, how));
    simulation.monitor(() -> new RegistrationSpec(withinNs));
  }

  private static final class Member extends Client {
    private final Registration reg;

    Member(GlobalVarHolder gvh, Course course, RegistrationSettings settings) {
      super(gvh, course, THINK_MS);
      reg = registration("town", settings);
    }

    @Override
    protected boolean obtain(int round) {
      reg.do_register();
      await(() -> reg.mayRequest() || reg.failed().get());
      return reg.mayRequest();
    }

    @Override
    protected void use() {
      sleep(rng.nextLong(0, STAY_MS));
      do {
        reg.unregister();
        await(() -> reg.isUnregistered() || reg.failed().get());
      } while (!reg.isUnregistered());
    }
  }
}
