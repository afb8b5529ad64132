package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import org.junit.jupiter.api.Tag;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.election.Leader;
import org.starl.primitives.ledger.Allocation;
import org.starl.primitives.ledger.LedgerCall;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.ledger.LedgerPrim;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.ledger.TaskId;
import org.starl.primitives.ledger.TaskLedger;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.Registration;
import org.starl.shape.Shapes;
import org.starl.sim.RobotSpec;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;

/**
 * Election, ledger, registration, mutex, tubes and barrier in one app. After a restart it keeps the order of
 * docs/primitives.md: it says where it stands, leaves the way of others, and then waits for them.
 */
class TogetherTest {

  private static final int ROBOTS = 5;
  private static final int TASKS = 5;
  private static final long TRY_MS = 60_000;
  private static final String DOCK = "dock";
  private static final ItemPosition PLACE = new ItemPosition(DOCK, 2_500, 2_300);
  private static final Rectangle FLOOR = new Rectangle(0, 0, 5_000, 3_000);

  /** The leader asks for the tasks; each is done at the dock, by one robot at a time; then all meet. */
  private static final class Worker extends LogicThread {

    private final ItemPosition home;
    private final Registration reg;
    private final M_Mutex mutex;
    private final DistributedPathPlanning paths;
    private final LedgerPrim<Long> ledger;
    private final Election election;
    private final Barrier barrier;

    Worker(GlobalVarHolder gvh, ItemPosition home) {
      super(gvh);
      this.home = home;
      reg = new Registration(gvh, "floor");
      mutex = new M_Mutex(gvh, "floor");
      paths = new DistributedPathPlanning(gvh, "tubes", new OptimalPlanner(), FLOOR);
      ledger = new TaskLedger<>(gvh, "tasks", Shapes.LONG);
      election = new Election(gvh, "leader");
      barrier = new Barrier(gvh, "end");
    }

    @Override
    public List<Object> callStarL() {
      await("a fix", gvh.gps::hasFix);
      await("all are placed", () -> paths.unplaced().isEmpty());
      boolean isAtDock = PLACE.at().distanceMm(gvh.gps.pose().at()) < 1_000;
      paths.standHere(mutex, isAtDock ? List.of(DOCK) : List.of(), TRY_MS);
      drive(home);
      mutex.standsIn(List.of());
      await("the ledger", ledger.ready()::get);
      election.do_election();
      every(1_000, this::ask);
      while (ledger.added("tasks") < TASKS || !ledger.tasks().isEmpty()) {
        SortedSet<TaskId> mine = ledger.held().get();
        Optional<TaskId> next = Allocation.nearest(ledger.tasks().values(), any -> 0);
        if (!mine.isEmpty()) {
          work(mine.first());
        } else if (next.isPresent()) {
          told(ledger.claim(next.get()));
        } else {
          sleep(500);
        }
      }
      do {
        barrier.arrive();
        await("the end", () -> barrier.outcome().get().isTold());
      } while (barrier.outcome().get() instanceof BarrierOutcome.Unknown);
      return List.of("done");
    }

    private void ask() {
      long added = ledger.added("tasks");
      if (election.failed().get()) {
        election.do_election();
      }
      if (election.Leader().get() instanceof Leader.Name leader
          && leader.id().robot().equals(gvh.id.name())
          && added < TASKS) {
        ledger.add(new TaskId("tasks", added + 1), added);
      }
    }

    private void work(TaskId task) {
      MutexFailure failure;
      do {
        failure =
            reg.register(TRY_MS) ? mutex.acquire(List.of(DOCK), TRY_MS) : MutexFailure.DEADLINE;
      } while (failure != MutexFailure.NONE);
      drive(PLACE);
      boolean isMine = told(ledger.begin(task)) == LedgerOutcome.DONE;
      sleep(1_000);
      while (isMine && ledger.tasks().containsKey(task)) {
        told(ledger.finish(task));
      }
      drive(home);
      mutex.release(DOCK);
    }

    private void drive(ItemPosition place) {
      TubeFailure failure;
      do {
        failure = paths.drive(place, TRY_MS);
      } while (failure != TubeFailure.NONE);
    }

    private LedgerOutcome told(LedgerCall call) {
      await("the ledger", call::isDone);
      return call.outcome();
    }
  }

  static void fill(Simulation.Builder simulation) {
    List<RobotId> all = new ArrayList<>();
    for (int i = 0; i < ROBOTS; i++) {
      ItemPosition home = new ItemPosition("home", 500 + 1_000 * i, 400);
      all.add(new RobotId(simulation.settings().robotName() + i));
      Pose start = new Pose(home.at().xMm(), home.at().yMm(), StrictMath.PI / 2);
      simulation.robot(new RobotSpec(all.get(i), start, true, gvh -> new Worker(gvh, home)));
    }
    simulation
        .monitor(ElectionSpec::new)
        .monitor(BarrierSpec::new)
        .monitor(LedgerSpec::new)
        .monitor(MutexSpec::new)
        .monitor(TubesSpec::new);
  }

  @Tag("long")
  @StarlTest(seeds = 10, chaos = Envelope.MOVING)
  void allRobotsEndAfterCrashes(Simulation.Builder simulation, RunChecks checks) {
    fill(simulation);
    checks.check(result -> assertThat(result.results()).hasSize(ROBOTS));
  }
}
