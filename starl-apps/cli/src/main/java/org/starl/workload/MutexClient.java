package org.starl.workload;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexBounds;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.time.Time;

/**
 * Robots register, enter one or two of a few sections again and again, release them one by one, and
 * unregister.
 */
final class MutexClient extends Client {

  private static final List<String> MEMBERSHIPS = List.of("registered", "fixed");

  static final Parameter SECTIONS =
      new Parameter("sections", "4", "how many sections there are, 1 to 26", Form.whole(1, 26));
  static final Parameter MEMBERS =
      new Parameter(
          "members",
          MEMBERSHIPS.get(0),
          "registered: the registered robots; fixed: all robots, which tolerates no crash",
          Form.choice(MEMBERSHIPS));

  private static final String XID = "crossing";
  private static final long THINK_MS = 500;

  /** Maximum time until a section is released. */
  private static final long HOLD_MS = 400;

  private static final int MAX_REQUESTED = 2;

  /** Upper bound of the time to release two sections by a clock that is slow by a tenth. */
  private static final long D1_NS = 2 * Time.NS_PER_S;

  private final int sections;
  private final MutexPrim mux;
  private final @Nullable Registration reg;

  /**
   * @param reg the registration of the members, or null if all robots are members
   */
  private MutexClient(
      GlobalVarHolder gvh, Setup setup, int sections, MutexPrim mux, @Nullable Registration reg) {
    super(gvh, setup, THINK_MS);
    this.sections = sections;
    this.mux = mux;
    this.reg = reg;
    if (gvh.id.boot() > 1) {
      mux.standsIn(List.of()); // these sections have no place, so the robot is in none
    }
  }

  static void setUp(Setup setup) {
    int sections =
        (int) (long) setup.request().parse(SECTIONS, text -> Quantities.whole(text, 1, 26));
    boolean isOpen = setup.choice(MEMBERS, MEMBERSHIPS).equals("registered");
    MutexBounds bounds = MutexBounds.of(setup.robots(), D1_NS, Setup.deltaNs(setup.settings()));
    // After the bounds: a late grant violates the specification before the request fails.
    MutexTimes times = MutexTimes.DEFAULT.withDeadlineMs(2 * bounds.d2Ns() / Time.NS_PER_MS);
    setup.simulation().monitor(() -> new MutexSpec(bounds));
    setup.place(gvh -> {
      Registration reg =
          isOpen ? new Registration(gvh, XID, gvh.id.participants(), setup.registration()) : null;
      Membership members = reg == null ? M_Mutex.closedGroup(gvh, gvh.id.participants()) : reg;
      M_Mutex mutex = new M_Mutex(gvh, XID, members, times);
      return new MutexClient(gvh, setup, sections, mutex, reg);
    });
    if (isOpen) {
      setup.simulation().monitor(() -> new RegistrationSpec(setup.withinNs()));
    }
  }

  @Override
  protected void prepare() {
    if (reg != null) {
      register(reg);
    }
  }

  @Override
  protected boolean obtain(int round) {
    mux.do_mutex(some());
    await(() -> mux.crit().get() || mux.failed().get());
    return mux.od_mutex();
  }

  private Set<String> some() {
    Set<String> some = new TreeSet<>();
    for (int i = 0; i < MAX_REQUESTED; i++) {
      some.add(String.valueOf((char) ('A' + rng.nextInt(sections))));
    }
    return some;
  }

  @Override
  protected void use() {
    for (String section : List.copyOf(mux.held())) {
      sleep(rng.nextLong(0, HOLD_MS));
      mux.release(section);
    }
  }

  @Override
  protected void leave() {
    if (reg != null) {
      unregister(reg);
    }
  }
}
