package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.id.RobotId;
import org.starl.input.Form;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexBounds;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.mutex.PipelinePrim;
import org.starl.primitives.registration.Registration;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * Robots register, enter one or two of a few sections again and again, release them one by one, and
 * unregister. One that is removed while it holds sections may register again before it releases them.
 *
 * <p>With modes, each section is entered in one of them, drawn for each request.
 *
 * <p>With sequences, bodies pass two to four sections one after another, each from one into the next. A
 * body stays where it is when its robot's program restarts, and its next program resumes there.
 */
final class MutexClient extends Client {

  static final String CHANGING = "changing";

  static final Parameter SECTIONS =
      new Parameter("sections", "4", "how many sections there are", Form.whole(1, 26));
  static final Parameter MEMBERS =
      Parameter.choice(
          "members",
          "registered: the registered robots; changing: they also leave and come back;"
              + " fixed: all robots, which tolerates no crash",
          "registered",
          "fixed",
          CHANGING);

  static final String SOON = "soon";

  static final Parameter SUSPECT =
      Parameter.choice(
          "suspect",
          "whether a silent process is suspected of a crash after 10 s (late) or 2 s (soon)",
          "late",
          SOON);

  static final String SEQUENCE = "sequence";

  static final Parameter ORDER =
      Parameter.choice(
          "order",
          "whether a robot asks for sections all at once (set) or one after another (sequence)",
          "set",
          SEQUENCE);

  static final Parameter MODES =
      new Parameter(
          "modes",
          "0",
          "how many modes each section has; robots share it in one mode; 0: none, they never share",
          Form.whole(0, 4));
  static final Parameter CAPACITY =
      new Parameter(
          "capacity",
          "0",
          "how many robots share a section in one mode; 0: any number",
          Form.whole(0, 64));

  /** Shorter than some waits. */
  private static final long SOON_MS = 2_000;

  private static final String XID = "crossing";
  private static final long THINK_MS = 500;

  /** Maximum time until a section is released. */
  private static final long HOLD_MS = 400;

  private static final int MAX_REQUESTED = 2;
  private static final int LONGEST = 4;

  /**
   * The way of a body.
   *
   * @param in the sections in which it is
   * @param path these and the sections to pass
   */
  private record Body(SortedSet<String> in, List<String> path) {
    static final Body OUTSIDE = new Body(Sections.NONE, List.of());
  }

  /**
   * The names of sections.
   *
   * @param modes how many each section has
   * @param capacity of each mode; 0 for any number
   */
  private record Names(int sections, int modes, int capacity) {

    static Names of(Request request) {
      return new Names(request.whole(SECTIONS), request.whole(MODES), request.whole(CAPACITY));
    }

    String name(int section, Rng rng) {
      String place = String.valueOf((char) ('A' + section));
      if (modes == 0) {
        return place;
      }
      return place + "/m" + rng.nextInt(modes) + (capacity == 0 ? "" : "*" + capacity);
    }
  }

  /** Upper bound of the time to release two sections by a clock that is slow by a tenth. */
  private static final long D1_NS = 2 * Time.NS_PER_S;

  /** The same by a clock without error. */
  private static final long CALM_D1_NS = MAX_REQUESTED * HOLD_MS * Time.NS_PER_MS;

  /**
   * From a suspicion until a dead participant that a request waits for is confined, with messages that
   * take no time.
   */
  private static final long CONFINED_MS = 8_000;

  private static final long SLACK_NS = Time.NS_PER_MS;

  /** Each other robot may hold two sections first. */
  private static final long PROMPT_EACH_MS = MAX_REQUESTED * HOLD_MS;

  private static final long PROMPT_MS = 500;
  private static final int PROMPT_MESSAGES = 40;

  /** How often a robot leaves after a round, if members change. */
  private static final double LEAVES = 0.3;

  private final Names names;
  private final boolean leaves;

  /** A robot that waits longer waits for a silent one. */
  private final long patienceMs;

  private final PipelinePrim mux;
  private final @Nullable Registration reg;

  /** Of all robots, whose programs may restart; null if robots ask for sets. */
  private final @Nullable Map<RobotId, Body> bodies;

  /**
   * @param patienceMs a robot that waits longer waits for a silent one
   * @param leaves whether the robot leaves after some rounds
   * @param reg the registration of the members, or null if all robots are members
   * @param bodies of all robots, whose programs may restart; null if robots ask for sets
   */
  private MutexClient(
      GlobalVarHolder gvh,
      Setup setup,
      Names names,
      long patienceMs,
      boolean leaves,
      PipelinePrim mux,
      @Nullable Registration reg,
      @Nullable Map<RobotId, Body> bodies) {
    super(gvh, setup, THINK_MS);
    this.names = names;
    this.patienceMs = patienceMs;
    this.leaves = leaves;
    this.mux = mux;
    this.reg = reg;
    this.bodies = bodies;
    if (gvh.id.boot() > 1) {
      // Sections of sets have no place, so the robot is in none.
      mux.resume(body().in(), body().path());
    }
  }

  static void setUp(Setup setup) {
    Names names = Names.of(setup.request());
    String members = setup.request().choice(MEMBERS);
    boolean isOpen = !members.equals("fixed");
    MutexBounds bounds = MutexBounds.of(setup.robots(), D1_NS, Setup.deltaNs(setup.settings()));
    // After the bounds: a late grant violates the specification before the request fails.
    boolean isSoon = setup.request().choice(SUSPECT).equals(SOON);
    long suspectMs = isSoon ? SOON_MS : MutexTimes.DEFAULT.suspectMs();
    boolean isSequence = setup.request().choice(ORDER).equals(SEQUENCE);
    MutexTimes times =
        MutexTimes.DEFAULT
            .withDeadlineMs(2 * bounds.d2Ns() / Time.NS_PER_MS)
            .withSuspectMs(suspectMs);
    long confinedNs = (suspectMs + CONFINED_MS) * Time.NS_PER_MS + 10 * setup.delayNs();
    MutexBounds calm =
        setup.isLossless()
            ? MutexBounds.of(setup.robots(), CALM_D1_NS, setup.delayNs() + SLACK_NS)
            : null;
    setup
        .simulation()
        .monitor(() -> {
          MutexSpec spec = new MutexSpec(bounds, calm).answering();
          if (names.modes() > 0) {
            spec.withModes();
          } else if (isSequence) {
            spec.withSequences();
          }
          return isOpen && setup.isLossless() ? spec.confinedWithin(confinedNs) : spec;
        });
    setup.promise(PROMPT_MS + setup.robots() * PROMPT_EACH_MS, PROMPT_MESSAGES, false);
    Map<RobotId, Body> bodies = isSequence ? new TreeMap<>() : null;
    setup.place(gvh -> {
      Registration reg =
          isOpen ? new Registration(gvh, XID, gvh.id.participants(), setup.registration()) : null;
      Membership group = reg == null ? M_Mutex.closedGroup(gvh, gvh.id.participants()) : reg;
      M_Mutex mutex = new M_Mutex(gvh, XID, group, times);
      boolean isChanging = members.equals(CHANGING);
      return new MutexClient(gvh, setup, names, suspectMs / 2, isChanging, mutex, reg, bodies);
    });
    if (isOpen) {
      setup.simulation().monitor(() -> setup.registered(setup.registration()));
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
    request();
    if (reg != null
        && leaves
        && body().in().isEmpty()
        && rng.nextBoolean(LEAVES)
        && !isTrueWithin(this::isAnswered, patienceMs)) {
      giveUpWithOthers(reg);
    }
    await(this::isAnswered);
    while (mux.failure().get() == MutexFailure.LATE) { // a calm world has these, too
      pause(rng.nextLong(0, THINK_MS));
      prepare();
      request();
      await(this::isAnswered);
    }
    return mux.od_mutex();
  }

  private boolean isAnswered() {
    return mux.crit().get() || mux.failed().get();
  }

  /**
   * Gives up when another change of the list is proposed: that of a silent robot. Asks again after it,
   * in half of the cases as another member.
   */
  private void giveUpWithOthers(Registration registration) {
    await(() -> isAnswered() || !registration.rList().get().isAgreed());
    if (!isAnswered()) {
      mux.withdraw();
      if (rng.nextBoolean(0.5)) {
        leave();
      } else {
        await(() -> registration.rList().get().isAgreed() || !registration.mayRequest());
      }
      prepare();
      request();
    }
  }

  private void request() {
    if (bodies == null) {
      mux.do_mutex(some());
      return;
    }
    if (body().in().isEmpty()) {
      moves(Sections.NONE, someInOrder());
    }
    mux.doSequence(body().path());
  }

  /** Two to four sections, or all if there are fewer; in half of the cases in the order of their names. */
  private List<String> someInOrder() {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < names.sections(); i++) {
      all.add(names.name(i, rng));
    }
    int length = (int) Math.min(rng.nextLong(MAX_REQUESTED, LONGEST), names.sections());
    List<String> some = new ArrayList<>();
    while (some.size() < length) {
      some.add(all.remove(rng.nextInt(all.size())));
    }
    if (rng.nextBoolean(0.5)) {
      some.sort(null);
    }
    return List.copyOf(some);
  }

  private Body body() {
    return bodies == null ? Body.OUTSIDE : bodies.getOrDefault(gvh.id.name(), Body.OUTSIDE);
  }

  private void moves(SortedSet<String> in, List<String> path) {
    if (bodies != null) {
      bodies.put(gvh.id.name(), new Body(in, path));
    }
  }

  private Set<String> some() {
    Set<Integer> some = new TreeSet<>();
    for (int i = 0; i < MAX_REQUESTED; i++) {
      some.add(rng.nextInt(names.sections()));
    }
    Set<String> all = new TreeSet<>();
    some.forEach(section -> all.add(names.name(section, rng)));
    return all;
  }

  @Override
  protected void use() {
    if (bodies != null) {
      drive();
    }
    for (String section : List.copyOf(mux.held())) {
      pause(rng.nextLong(0, HOLD_MS));
      if (reg != null && !reg.mayRequest() && rng.nextBoolean(0.5)) {
        register(reg);
      }
      mux.release(section);
    }
    if (leaves && rng.nextBoolean(LEAVES)) {
      leave();
    }
  }

  /** Passes the sections of the path, each as soon as it is granted. */
  private void drive() {
    List<String> path = body().path();
    while (!path.isEmpty()) {
      String here = path.get(0);
      List<String> rest = path.subList(1, path.size());
      reach(here);
      moves(Sections.union(body().in(), List.of(here)), path);
      pause(rng.nextLong(0, HOLD_MS / 2));
      if (!rest.isEmpty()) {
        reach(rest.get(0));
        moves(Sections.union(body().in(), rest.subList(0, 1)), path);
        pause(rng.nextLong(0, HOLD_MS / 2));
      }
      moves(Sections.without(body().in(), List.of(here)), rest);
      mux.release(here);
      path = rest;
    }
  }

  /** Waits for the next section; if the request ends, asks again for the whole rest of the path. */
  private void reach(String section) {
    while (!mux.held().contains(section)) {
      if (mux.failed().get()) {
        pause(rng.nextLong(0, THINK_MS));
        prepare();
        mux.doSequence(body().path());
      }
      await(() -> mux.held().contains(section) || mux.failed().get());
    }
  }

  @Override
  protected void leave() {
    if (reg != null) {
      unregister(reg);
    }
  }
}
