package org.starl.apps.fleet.logic;

import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Persistent;
import org.starl.apps.fleet.logic.FleetFact.Work;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.ledger.LedgerCall;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.ledger.LedgerPrim;
import org.starl.primitives.ledger.LedgerSettings;
import org.starl.primitives.ledger.LedgerTask;
import org.starl.primitives.ledger.TaskId;
import org.starl.primitives.ledger.TaskLedger;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexTimes;
import org.starl.primitives.registration.Registration;
import org.starl.random.Rng;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.time.Time;

/**
 * A robot of a fleet: takes deliveries from the ledger, fetches and brings them along the lanes, charges
 * its battery, and waits at its home. No robot manages the others: the ledger says which robot does a
 * delivery, the mutex which one is in a section or at a charger.
 */
public final class FleetApp extends LogicThread {

  private static final String DELIVERIES = "deliveries";
  private static final int VOTERS = 5;
  private static final long PERIOD_MS = 100;
  private static final long HANDLE_MS = 2_000;
  private static final long TRY_MS = 60_000;
  private static final long MOMENT_MS = 10_000;
  // The station of a delivery is free soon, unless a robot is lost there.
  private static final long STATION_MS = 60_000;
  private static final long ROOM_MS = 2_000;
  // Robots wait for each other for minutes. With 30 % loss, a live one is silent for 10 s now and
  // then, for 30 s never.
  private static final MutexTimes TIMES = MutexTimes.DEFAULT.withSuspectMs(30_000);
  private static final LedgerSettings LEASES =
      new LedgerSettings(SynodTiming.DEFAULT, 2_000, 30_000, 30_000);
  private static final long TURN_NS = 15 * Time.NS_PER_S;
  private static final double SURE_MM = 45;
  private static final double AT_HOME_MM = 60;

  // A nearer robot claims a delivery before a farther one does, up to this way.
  private static final double FAR_MM = 40_000;
  private static final double FAR_MS = 2_000;
  // Another robot at a station, or on its way there, is as this way.
  private static final double BUSY_MM = 10_000;

  /**
   * The load of the delivery that this robot has begun.
   *
   * @param number of the delivery; 0 for no load
   * @param isDown whether it is put down
   */
  private record Load(long number, boolean isDown) {
    static final Load NONE = new Load(0, false);
    static final Shape<Load> SHAPE =
        Shapes.of(
            Load.class,
            part("number", Shapes.LONG, Load::number),
            part("isDown", Shapes.BOOL, Load::isDown),
            Load::new);
  }

  private final Roads roads;
  private final List<Delivery> deliveries;
  private final double rangeMm;
  private final boolean isBroken;
  private final int number;
  private final int robots;
  private final int home;
  private final Registration floorList;
  private final M_Mutex floor;
  private final Places places;
  private final LedgerPrim<Delivery> ledger;
  private final Rng rng;
  private final Persistent<Load> load;
  private final Persistent<Integer> goal; // the private vertex to which the robot drives
  private final Choice choice = new Choice();
  private final Closures closures;
  private final GvhCell<Work> work;
  private final GvhCell<List<Integer>> way;
  private final GvhCell<List<Integer>> lane;
  private final GvhCell<Long> aboard;
  private final GvhCell<Long> delivered;
  private int at; // the private vertex where the robot stands, or from where it drives
  private @Nullable LedgerCall adding;
  private @Nullable Battery battery;

  /**
   * @param deliveries in the order of their times, the same on all robots
   * @param rangeMm way on one charge of the battery; 0 for a battery that is never empty
   * @param isBroken whether a program that starts anew on this robot does not drive
   */
  public FleetApp(
      GlobalVarHolder gvh,
      Roads roads,
      List<Delivery> deliveries,
      double rangeMm,
      boolean isBroken) {
    super(gvh);
    this.isBroken = isBroken;
    this.roads = roads;
    this.deliveries = List.copyOf(deliveries);
    this.rangeMm = rangeMm;
    List<RobotId> all = gvh.id.participants().asList();
    number = all.indexOf(gvh.id.name());
    robots = all.size();
    home = roads.home(number);
    at = home;
    Participants voters = Participants.of(all.subList(0, Math.min(VOTERS, robots)));
    floorList = new Registration(gvh, "floor", voters);
    floor = new M_Mutex(gvh, "floor", floorList, TIMES);
    places = new Places(gvh, roads, home, voters, TIMES);
    closures = new Closures(gvh, roads, floor, places);
    ledger = new TaskLedger<>(gvh, DELIVERIES, Delivery.SHAPE.where(this::check), voters, LEASES);
    rng = gvh.plat.entropy.fork("app");
    load = gvh.plat.persistent("load", Load.SHAPE, Load.NONE);
    goal = gvh.plat.persistent("goal", Shapes.INT, home);
    work = gvh.variable(FleetFact.WORK, Work.STARTS);
    way = gvh.variable(FleetFact.WAY, List.of());
    lane = gvh.variable(FleetFact.LANE, List.of());
    aboard = gvh.variable(FleetFact.ABOARD, 0L);
    delivered = gvh.variable(FleetFact.DELIVERED, 0L);
    MotionParameters body = gvh.plat.moat.parameters();
    gvh.plat.moat.setParameters(
        body.toBuilder()
            .goalRadiusMm(10)
            .constantSpeed()
            .enableArcing(false)
            .smallTurnAngleRad(Angles.fromDegrees(1))
            .collisionPolicy(CollisionPolicy.STOP_ON_COLLISION)
            .build());
  }

  /** Refuses a delivery that another robot has from another map. */
  private void check(Delivery delivery) {
    int vertices = roads.graph().vertices().size();
    for (int stop : delivery.stops()) {
      if (stop < 0 || stop >= vertices) {
        throw new IllegalArgumentException("vertex " + stop + ": expected below " + vertices);
      }
    }
  }

  @Override
  public List<Object> callStarL() {
    every(500, this::addDue);
    await("a good fix", () -> gvh.gps.errorMm() < SURE_MM);
    battery = new Battery(gvh, rangeMm);
    if (isBroken && gvh.id.boot() > 1) {
      stay();
      return List.of();
    }
    leaveLanes();
    await("the ledger", ledger.ready()::get);
    List<Object> done = new ArrayList<>();
    while (ledger.added(DELIVERIES) < deliveries.size() || !ledger.tasks().isEmpty()) {
      SortedSet<TaskId> mine = ledger.held().get(); // also by a call that was told UNKNOWN
      boolean mayDrive = battery().suffices(roads.longestMm());
      if (!mayDrive) {
        goHome();
        charge();
      } else if (!mine.isEmpty()) {
        deliver(mine.first(), done);
      } else {
        choose();
        battery().tick(false);
      }
    }
    goHome();
    work.set(Work.ENDS);
    return done;
  }

  /** Adds the delivery that is due: this robot if it is its turn, or the next one if that is silent. */
  private void addDue() {
    long next = ledger.added(DELIVERIES) + 1;
    boolean isReady = ledger.ready().get() && (adding == null || adding.isDone());
    if (!isReady || next > deliveries.size()) {
      return;
    }
    Delivery delivery = deliveries.get((int) next - 1);
    long lateNs = gvh.plat.clock.nowNs() - delivery.atNs();
    if (lateNs >= 0 && (next + lateNs / TURN_NS) % robots == number) {
      adding = ledger.add(new TaskId(DELIVERIES, next), delivery);
    }
  }

  /**
   * Claims the nearest open delivery, if the lists of the mutexes have room for this robot. Of several
   * robots the nearest one is first, mostly. Without a delivery the robot goes home: others need the
   * station.
   */
  private void choose() {
    Optional<TaskId> next = nearest();
    LedgerTask<Delivery> its = next.isPresent() ? ledger.tasks().get(next.get()) : null;
    if (its == null) {
      goHome();
      work.set(Work.PARKS);
      leaveLists();
      sleep(500);
      return;
    }
    sleep(1 + (long) (FAR_MS * Math.min(1, awayMm(its.what()) / FAR_MM)));
    if (!next.equals(nearest())) {
      return;
    }
    if (floorList.register(ROOM_MS) && places.register(its.what().pick(), ROOM_MS)) {
      told(ledger.claim(its.id()));
    } else {
      goHome();
      leaveLists();
      sleep(rng.nextLong(ROOM_MS, 10 * ROOM_MS));
    }
  }

  /** A robot that parks makes room for others. */
  private void leaveLists() {
    List<Registration> lists = new ArrayList<>(places.lists());
    lists.add(floorList);
    for (Registration list : lists) {
      while (list.mayRequest()) {
        list.unregister();
        await("a list", () -> list.isUnregistered() || list.failed().get());
      }
    }
  }

  private Optional<TaskId> nearest() {
    List<LedgerTask<Delivery>> tasks = List.copyOf(ledger.tasks().values());
    return choice.nearest(tasks, this::isShut, gvh.plat.clock.nowNs(), this::awayMm);
  }

  private boolean isShut(Delivery delivery) {
    return closures.isShut(at, List.of(delivery.pick(), delivery.drop(), home));
  }

  private double awayMm(Delivery delivery) {
    return roads.at(delivery.pick()).distanceMm(roads.at(at))
        + BUSY_MM * places.contenders(delivery.pick());
  }

  /** Does a delivery that this robot has claimed or begun, or the part that is left of it. */
  private void deliver(TaskId task, List<Object> done) {
    LedgerTask<Delivery> its = ledger.tasks().get(task);
    if (its == null) {
      sleep(500);
      return;
    }
    if (!its.isBegun() && isShut(its.what())) {
      told(ledger.giveBack(task));
      return;
    }
    Load onTheWay = new Load(task.number(), false);
    Load down = new Load(task.number(), true);
    if (!load.get().equals(down)) {
      carry(task, its.what(), onTheWay, down);
    }
    if (load.get().equals(down)) {
      while (ledger.tasks().containsKey(task)) {
        told(ledger.finish(task));
      }
      store(load, Load.NONE);
      done.add(task.number());
    }
  }

  /** Drives to the station that is next, or over both, and on to a private vertex. */
  private void carry(TaskId task, Delivery delivery, Load onTheWay, Load down) {
    boolean isFree = isAboard(onTheWay);
    List<Integer> leg = roads.leg(at, isFree ? List.of(delivery.drop()) : delivery.stops(), home);
    int from = at;
    int end = leg.get(leg.size() - 1);
    if (!enter(end, () -> isFree || (ledger.held().get().contains(task) && !isShut(delivery)))) {
      return; // it has gone home, or no longer has its claim, or a dead robot is in the way
    }
    Journey journey = journey(List.of(from), leg, List.of(home, from, end));
    for (int i = 0; i < leg.size(); i++) {
      int stop = leg.get(i);
      work.set(isAboard(onTheWay) ? Work.CARRIES : stop == home ? Work.RETURNS : Work.FETCHES);
      drive(journey, i);
      if (isAboard(onTheWay) && stop == delivery.drop()) {
        sleep(HANDLE_MS);
        store(load, down);
        aboard.set(0L);
        delivered.set(task.number());
      } else if (stop == delivery.pick()
          && !load.get().equals(down)
          && told(ledger.begin(task)) == LedgerOutcome.DONE) {
        sleep(HANDLE_MS);
        store(load, onTheWay);
        aboard.set(task.number());
      }
    }
    arrive(end);
  }

  /**
   * Gets a private vertex before the robot drives there. At a station, where others may wait for it, it
   * waits for a minute at most, and then goes home; so no robots wait for each other's stations.
   *
   * @param isWanted asked after each failed request; false ends the search
   * @return whether it holds the vertex
   */
  private boolean enter(int vertex, BooleanSupplier isWanted) {
    if (vertex == at) {
      return true;
    }
    if (at != home) {
      boolean isGot = places.mayAsk(at, vertex) && places.acquire(vertex, STATION_MS);
      if (!isGot) {
        goHome();
      }
      return isGot;
    }
    boolean isGot;
    do {
      isGot = places.acquire(vertex, TRY_MS);
    } while (!isGot && isWanted.getAsBoolean());
    return isGot;
  }

  /** The body has left the last private vertex and is at this one. */
  private void arrive(int vertex) {
    if (vertex != at) {
      places.leave(at);
      at = vertex;
    }
  }

  private void goHome() {
    if (at != home) {
      work.set(isLoaded() ? Work.CARRIES : Work.RETURNS);
      driveOver(at, home);
      arrive(home);
    }
  }

  private boolean isAboard(Load onTheWay) {
    return load.get().equals(onTheWay);
  }

  private boolean isLoaded() {
    return load.get().number() > 0 && !load.get().isDown();
  }

  /**
   * From where the body stands after a restart to a private vertex near by. The way home would be longer,
   * over sections in which others stand that have restarted too and need those of this body.
   */
  private void leaveLanes() {
    Point stands = gvh.gps.pose().at();
    if (stands.distanceMm(roads.at(home)) < AT_HOME_MM) {
      if (gvh.id.boot() > 1) {
        floor.resume(List.of(), List.of());
        places.standsIn(List.of());
      }
      return;
    }
    NavGraph.Lane lane = roads.laneAt(stands, home);
    places.standsIn(List.of(lane.from(), lane.to(), goal.get()));
    List<Integer> refuges = new ArrayList<>(List.of(goal.get()));
    refuges.addAll(roads.refuges(stands, home));
    int tried = 0;
    while (!places.acquire(refuges.get(tried), MOMENT_MS)) {
      tried++; // the last one is its home, which it always has
    }
    int end = refuges.get(tried);
    NavGraph.Lane first = roads.laneAt(stands, end);
    List<Integer> own = List.of(home, first.from(), first.to(), end);
    Journey journey = journey(List.of(first.from(), first.to()), List.of(end), own);
    List<String> sections =
        new ArrayList<>(roads.occupied(stands, gvh.gps.errorMm(), own.subList(0, 3)));
    sections.addAll(roads.groups(stands, first));
    journey.resume(first, sections);
    drive(journey, 0);
    arrive(end);
    places.standsIn(List.of());
  }

  /**
   * A broken robot gives back what its body is not in, and its delivery, unless the load is aboard. Its
   * program may run on another computer: where the body is comes from the positioning.
   */
  private void stay() {
    Point stands = gvh.gps.pose().at();
    boolean isAtHome = stands.distanceMm(roads.at(home)) < AT_HOME_MM;
    NavGraph.Lane lane = roads.laneAt(stands, home);
    List<Integer> ends = List.of(lane.from(), lane.to());
    List<String> sections = new ArrayList<>();
    if (!isAtHome) {
      sections.addAll(roads.occupied(stands, gvh.gps.errorMm(), ends));
      sections.addAll(roads.groups(stands, lane));
    }
    floor.standsIn(sections);
    places.standsIn(isAtHome ? List.of() : ends);
    await("the ledger", ledger.ready()::get);
    if (load.get().equals(Load.NONE)) {
      for (TaskId task : ledger.held().get()) {
        told(ledger.reopen(task));
      }
    }
    work.set(Work.ENDS);
  }

  /** Charges at its home, where it stands, or at a charger. */
  private void charge() {
    boolean isAtHome = roads.graph().vertices().get(home).isCharger();
    int charger = isAtHome ? home : nearestCharger();
    work.set(Work.PARKS);
    enter(charger, () -> true);
    work.set(Work.CHARGES);
    driveOver(home, charger);
    arrive(charger);
    while (!battery().isFull()) {
      sleep(1_000);
      battery().tick(true);
    }
    goHome();
  }

  private void driveOver(int from, int to) {
    drive(journey(List.of(from), List.of(to), List.of(home, from, to)), 0);
  }

  /** The nearest one of those for which fewest robots wait. */
  private int nearestCharger() {
    return roads.chargers().stream()
        .min(
            Comparator.<Integer, Boolean>comparing(closures::isAt)
                .thenComparingInt(each -> places.contenders(each))
                .thenComparingDouble(each -> roads.at(each).distanceMm(roads.at(home))))
        .orElseThrow();
  }

  private Journey journey(List<Integer> begin, List<Integer> stops, List<Integer> own) {
    store(goal, stops.get(stops.size() - 1));
    return new Journey(
        gvh, roads, floorList, floor, begin, stops, closures::sections, own, way, lane);
  }

  private void drive(Journey journey, int stop) {
    while (!journey.step(stop)) {
      sleep(PERIOD_MS);
      battery().tick(false);
    }
  }

  private Battery battery() {
    Battery its = battery;
    if (its == null) {
      throw new IllegalStateException("no battery before the first fix");
    }
    return its;
  }

  private <T> void store(Persistent<T> variable, T value) {
    variable.set(value);
    await("storage", variable::isFlushed);
  }

  private LedgerOutcome told(LedgerCall call) {
    await("the ledger", call::isDone);
    return call.outcome();
  }
}
