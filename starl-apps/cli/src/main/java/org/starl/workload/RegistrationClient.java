package org.starl.workload;

import org.starl.GlobalVarHolder;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSpec;

/** Robots register, stay a while, and unregister. */
final class RegistrationClient extends Client {

  private static final long THINK_MS = 500;
  private static final long STAY_MS = 1_000;

  private final Registration reg;

  private RegistrationClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    reg = registration("town", setup.registration());
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new RegistrationClient(gvh, setup));
    setup.simulation().monitor(() -> new RegistrationSpec(setup.withinNs()));
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
    unregister(reg);
  }
}
