package org.starl.workload;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexBounds;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/**
 * {@code starl campaign mutex}: robots register, enter one or two of a few sections again and again,
 * give them back one by one, and unregister.
 */
final class MutexWorkload extends PrimitiveDemo {

  private static final String XID = "crossing";
  private static final long THINK_MS = 500;

  /** A section is given back after so long at most. */
  private static final long HOLD_MS = 400;

  private static final int MOST_WANTED = 2;

  /** More than it takes to give back two sections by a clock that is slow by a tenth. */
  private static final long D1_NS = 2_000_000_000;

  private static final long NS_PER_MS = 1_000_000;

  private static final Parameter SECTIONS =
      new Parameter("sections", "4", "how many sections there are, 1 to 26", Form.whole(1, 26));
  private static final Parameter MEMBERS =
      new Parameter(
          "members",
          "registered",
          "registered: who registers; fixed: all robots, for ever, which bears no crash",
          Form.choice(List.of("registered", "fixed")));

  MutexWorkload() {
    super("mutex", "robots enter sets of sections, each again and again, over a registration");
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(10), busy("20s"), SECTIONS, MEMBERS);
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    int sections = whole(request, SECTIONS.key(), 1, 26);
    int robots = count(request, 1, 32);
    long deltaNs = Bounds.deltaNs(settings);
    MutexBounds bounds = MutexBounds.of(robots, D1_NS, deltaNs);
    // Later than the bounds, so that what does not come by then is seen, and not told before.
    MutexTimes times = MutexTimes.DEFAULT.withDeadlineMs(2 * bounds.d2Ns() / NS_PER_MS);
    simulation.monitor(() -> new MutexSpec(XID, bounds));
    long withinNs = Bounds.withinNs(settings);
    RegistrationSettings how =
        RegistrationSettings.DEFAULT.withDeadlineMs(Bounds.deadlineMs(withinNs));
    if (isOpen(request.parameter(MEMBERS.key()))) {
      place(
          simulation,
          settings,
          robots,
          gvh -> {
            Registration reg = new Registration(gvh, XID, gvh.id.participants(), how);
            return new Car(gvh, course, sections, new M_Mutex(gvh, XID, reg, times), reg);
          });
      simulation.monitor(() -> new RegistrationSpec(withinNs));
    } else {
      place(
          simulation,
          settings,
          robots,
          gvh -> {
            Membership all = M_Mutex.closedGroup(gvh, gvh.id.participants());
            return new Car(gvh, course, sections, new M_Mutex(gvh, XID, all, times), null);
          });
    }
  }

  private static boolean isOpen(String members) {
    return switch (members) {
      case "registered" -> true;
      case "fixed" -> false;
      default ->
          throw new BadInput(
              "members=" + BadInput.quote(members) + ": expected registered or fixed");
    };
  }

  private static final class Car extends Client {
    private final int sections;
    private final MutexPrim mux;
    private final @Nullable Registration reg;

    /**
     * @param reg whose members enter, or null if all robots are
     */
    Car(
        GlobalVarHolder gvh,
        Course course,
        int sections,
        MutexPrim mux,
        @Nullable Registration reg) {
      super(gvh, course, THINK_MS);
      this.sections = sections;
      this.mux = mux;
      this.reg = reg;
      if (gvh.id.boot() > 1) {
        mux.standsIn(List.of()); // these sections are nowhere, so nobody stands in one
      }
    }

    @Override
    protected void prepare() {
      while (reg != null && !reg.mayRequest()) {
        reg.do_register();
        await(() -> reg.mayRequest() || reg.failed().get());
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
      for (int i = 0; i < MOST_WANTED; i++) {
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
      while (reg != null && !reg.isUnregistered()) {
        reg.unregister();
        await(() -> reg.isUnregistered() || reg.failed().get());
      }
    }
  }
}
