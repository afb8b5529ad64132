package org.starl.apps.recipes;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Persistent;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.primitives.ledger.Allocation;
import org.starl.primitives.ledger.LedgerCall;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.ledger.LedgerPrim;
import org.starl.primitives.ledger.TaskId;
import org.starl.primitives.ledger.TaskLedger;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.registration.Registration;
import org.starl.shape.Shapes;
import org.starl.trace.Var;

/**
 * A robot of a warehouse: carries crates from the west room through the aisle into the east room. The
 * ledger says who carries which crate; the mutex, who is in the aisle in which direction, and who is at a
 * station; reach tubes keep bodies apart.
 */
final class WarehouseApp extends LogicThread {

  static final Var<String> LANE = Var.of("lane", Shapes.TEXT);
  static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);
  static final Var<Long> DELIVERED = Var.of("delivered", Shapes.LONG);

  /** A bug to plant. */
  enum Bug {
    NONE,
    /** The two directions of the aisle are sections of their own, which exclude nothing. */
    NO_CONFLICT,
    /** A carrier that starts again believes that it has delivered its crate. */
    FORGETS
  }

  private static final String ORDERS = "orders";
  private static final String NOTHING = "";
  private static final String ABOARD = "aboard";
  private static final String DOWN = "down";
  private static final String EAST = "east";
  private static final String WEST = "west";
  private static final long TRY_MS = 60_000;

  private final int number;
  private final int orders;
  private final Bug bug;
  private final Registration reg;
  private final M_Mutex mutex;
  private final DistributedPathPlanning paths;
  private final LedgerPrim<Long> ledger;
  private final Persistent<String> load; // of the crate of the begun task
  private final Persistent<String> direction; // in the aisle
  private final GvhCell<String> lane;
  private final GvhCell<String> location;
  private final GvhCell<Long> delivered;

  WarehouseApp(GlobalVarHolder gvh, int number, int orders, Bug bug) {
    super(gvh);
    this.number = number;
    this.orders = orders;
    this.bug = bug;
    reg = new Registration(gvh, "floor");
    mutex = new M_Mutex(gvh, "floor");
    paths = new DistributedPathPlanning(gvh, "tubes", new OptimalPlanner(), WarehouseFloor.ALL);
    ledger = new TaskLedger<>(gvh, "crates", Shapes.LONG);
    load = gvh.plat.persistent("load", Shapes.TEXT, NOTHING);
    direction = gvh.plat.persistent("direction", Shapes.TEXT, NOTHING);
    lane = gvh.variable(LANE, NOTHING);
    location = gvh.variable(LOCATION, "BEGIN");
    delivered = gvh.variable(DELIVERED, 0L);
  }

  @Override
  public List<Object> callStarL() {
    await("a fix", gvh.gps::hasFix);
    await("all are placed", () -> paths.unplaced().isEmpty());
    boolean isInAisle =
        WarehouseFloor.isInAisle(gvh.gps.pose()) && !direction.get().equals(NOTHING);
    List<String> stands = isInAisle ? aisle(direction.get()) : List.of();
    paths.standHere(mutex, stands, TRY_MS);
    lane.set(isInAisle ? direction.get() : NOTHING);
    await("the ledger", ledger.ready()::get);
    for (int order = 1; order <= orders; order++) {
      told(ledger.add(new TaskId(ORDERS, order), (long) order));
    }
    List<Object> carried = new ArrayList<>();
    leaveAisle();
    drive(place()); // it may stand at a station, in another robot's way
    for (TaskId task : ledger.held().get()) {
      carry(task, carried);
    }
    goHome();
    while (!ledger.tasks().isEmpty()) {
      location.set("FREE");
      SortedSet<TaskId> mine = ledger.held().get(); // also by a call that was told UNKNOWN
      Optional<TaskId> next =
          Allocation.nearest(
              ledger.tasks().values(),
              order -> WarehouseFloor.pick(order).at().distanceMm(gvh.gps.pose().at()));
      if (!mine.isEmpty()) {
        carry(mine.first(), carried);
        goHome();
      } else if (next.isPresent() && told(ledger.claim(next.get())) == LedgerOutcome.DONE) {
        carry(next.get(), carried);
        goHome();
      } else {
        sleep(500);
      }
    }
    location.set("DONE");
    return carried;
  }

  /** Carries the crate of a task that this robot has claimed or begun. */
  private void carry(TaskId task, List<Object> carried) {
    if (load.get().equals(NOTHING)) {
      location.set("PICK");
      ItemPosition pick = WarehouseFloor.pick(task.number());
      acquire(List.of(pick.name()));
      drive(pick);
      boolean isMine = told(ledger.begin(task)) == LedgerOutcome.DONE;
      if (isMine) {
        sleep(1_000);
        store(load, ABOARD);
      }
      drive(WarehouseFloor.home(number));
      mutex.release(pick.name());
      if (!isMine) {
        return;
      }
    }
    boolean isDown = load.get().equals(DOWN) || (bug == Bug.FORGETS && gvh.id.boot() > 1);
    if (!isDown) {
      cross(EAST, WarehouseFloor.bay(number));
      location.set("DROP");
      ItemPosition drop = WarehouseFloor.drop(task.number());
      acquire(List.of(drop.name()));
      drive(drop);
      sleep(1_000);
      store(load, DOWN);
      delivered.set(task.number());
      drive(WarehouseFloor.bay(number));
      mutex.release(drop.name());
    }
    while (ledger.tasks().containsKey(task)) {
      told(ledger.finish(task));
    }
    store(load, NOTHING);
    carried.add(task.number());
  }

  /** Where it blocks no other robot. */
  private ItemPosition place() {
    boolean isEast = WarehouseFloor.isEast(gvh.gps.pose());
    return isEast ? WarehouseFloor.bay(number) : WarehouseFloor.home(number);
  }

  private void goHome() {
    cross(WEST, WarehouseFloor.home(number));
  }

  /** Drives through the aisle to {@code place} beyond it, unless the robot is there already. */
  private void cross(String way, ItemPosition place) {
    boolean isEastward = way.equals(EAST);
    if (WarehouseFloor.isEast(gvh.gps.pose()) == isEastward) {
      return;
    }
    location.set("AISLE");
    acquire(aisle(way));
    store(direction, way);
    lane.set(way);
    drive(isEastward ? WarehouseFloor.WEST_END : WarehouseFloor.EAST_END);
    drive(isEastward ? WarehouseFloor.EAST_END : WarehouseFloor.WEST_END);
    drive(place);
    leave();
  }

  /** After a restart in the aisle: goes on in its direction. */
  private void leaveAisle() {
    if (lane.get().equals(NOTHING)) {
      return;
    }
    boolean isEastward = lane.get().equals(EAST);
    drive(isEastward ? WarehouseFloor.EAST_END : WarehouseFloor.WEST_END);
    drive(isEastward ? WarehouseFloor.bay(number) : WarehouseFloor.home(number));
    leave();
  }

  private void leave() {
    if (!mutex.held().isEmpty()) {
      mutex.release(mutex.held());
    }
    mutex.standsIn(List.of());
    lane.set(NOTHING);
    store(direction, NOTHING);
  }

  /** Any number of robots in one direction; robots in different directions exclude each other. */
  private List<String> aisle(String way) {
    return List.of(bug == Bug.NO_CONFLICT ? "aisle-" + way : "aisle/" + way);
  }

  private void acquire(List<String> sections) {
    MutexFailure failure;
    do {
      failure = reg.register(TRY_MS) ? mutex.acquire(sections, TRY_MS) : MutexFailure.DEADLINE;
    } while (failure != MutexFailure.NONE);
  }

  private void drive(ItemPosition place) {
    TubeFailure failure;
    do {
      failure = paths.drive(place, TRY_MS);
    } while (failure != TubeFailure.NONE);
  }

  private void store(Persistent<String> variable, String value) {
    variable.set(value);
    await("storage", variable::isFlushed);
  }

  private LedgerOutcome told(LedgerCall call) {
    await("the ledger", call::isDone);
    return call.outcome();
  }
}
