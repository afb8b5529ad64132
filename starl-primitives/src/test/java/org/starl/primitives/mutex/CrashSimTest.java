package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.random.Rng;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.net.Latency;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Partition;
import org.starl.sim.world.Unsynced;
import org.starl.trace.TraceEvent;

/** Registration and mutex together on simulated robots with crashes, restarts and partitions. */
class CrashSimTest {

  private static final long MS = 1_000_000;
  private static final long S = 1_000 * MS;
  private static final String XID = "crossing";
  private static final List<RobotId> CARS = named("car", 4);
  private static final List<RobotId> ROADSIDE = named("post", 3);
  private static final MutexTimes TIMES =
      MutexTimes.DEFAULT.withDeadlineMs(20_000).withSuspectMs(6_000);

  private final List<MutexFact> story = new ArrayList<>();

  @Test
  void aPermanentlyCrashedRobotIsConfinedAndOthersContinue() {
    long fences = 0;
    for (long seed = 0; seed < 12; seed++) {
      SimResult result =
          run(
              seed,
              60 * S,
              MutexBounds.of(CARS.size(), 3 * S, 2 * S),
              control -> {
                Rng rng = control.scenarioRng("crash");
                control.at(rng.nextLong(5 * S, 15 * S), () -> control.crash(CARS.get(1)));
              });
      assertWell(result, seed);
      assertThat(result.results()).hasSize(CARS.size() - 1 + ROADSIDE.size());
      fences += count(MutexFact.Fence.class);
      assertThat(lastView().contains(latestOf(CARS.get(1)))).as("seed %d", seed).isFalse();
    }
    assertThat(fences).isPositive();
  }

  @Test
  void crashesRestartsAndWrongSuspicionsAreSafeAndAllContinue() {
    long removed = 0;
    for (long seed = 0; seed < 12; seed++) {
      SimResult result = run(seed, 150 * S, null, CrashSimTest::chaosFor100s);
      assertWell(result, seed);
      assertThat(result.results()).hasSize(CARS.size() + ROADSIDE.size());
      removed += count(MutexFact.Fence.class);
      assertThat(lastView().mentioned()).as("after all have unregistered, seed %d", seed).isEmpty();
    }
    assertThat(removed).isPositive();
  }

  @Test
  void anIsolatedRobotIsFencedIsToldAndRegistersAgain() {
    SimResult result =
        run(
            1,
            60 * S,
            null,
            control ->
                control.at(
                    5 * S,
                    () -> {
                      LinkRule.Handle cut =
                          control.network().install(Partition.isolating(CARS.get(0)));
                      control.at(35 * S, cut::uninstall);
                    }));
    assertWell(result, 1);
    assertThat(story)
        .anySatisfy(event -> assertThat(event).isInstanceOf(MutexFact.Fence.class))
        .filteredOn(event -> event instanceof MutexFact.Withdraw w && w.why().mustRegister())
        .extracting(event -> event.who().robot())
        .contains(CARS.get(0));
  }

  /** At most one car is down or cut off at a time, so that a majority of posts stays in reach. */
  private static void chaosFor100s(SimControl control) {
    Rng rng = control.scenarioRng("chaos");
    long atNs = 3 * S;
    while (atNs < 100 * S) {
      RobotId victim = CARS.get(rng.nextInt(CARS.size()));
      long forNs = rng.nextLong(S, 20 * S);
      Unsynced unsynced = Unsynced.values()[rng.nextInt(3)];
      boolean crashes = rng.nextBoolean(0.6);
      control.at(
          atNs,
          () -> {
            if (!control.isUp(victim)) {
              return;
            }
            if (crashes) {
              control.crash(victim, forNs, unsynced);
            } else {
              LinkRule.Handle cut = control.network().install(Partition.isolating(victim));
              control.at(control.nowNs() + forNs, cut::uninstall);
            }
          });
      atNs += forNs / 2 + rng.nextLong(0, 8 * S);
    }
  }

  private SimResult run(long seed, long untilNs, @Nullable MutexBounds bounds, Director director) {
    story.clear();
    SimSettings settings =
        SimSettings.builder()
            .set(Setting.MESSAGE_DELAY, new Latency.Uniform(10 * MS, 100 * MS))
            .set(Setting.MESSAGE_LOSS, 0.1)
            .duration(Duration.ofMinutes(15))
            .build();
    Simulation.Builder builder = Simulation.builder().seed(seed).settings(settings);
    for (RobotId post : ROADSIDE) {
      builder.robot(new RobotSpec(post, new Pose(0, 0, 0), false, gvh -> new Post(gvh, untilNs)));
    }
    for (RobotId car : CARS) {
      builder.robot(new RobotSpec(car, new Pose(0, 0, 0), false, gvh -> new Car(gvh, untilNs)));
    }
    return builder
        .monitor(() -> new MutexSpec(bounds))
        .monitor(MutexConformance::new)
        .monitor(() -> new RegistrationSpec(20 * S))
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof TraceEvent.Action action
                    && action.fact() instanceof MutexFact fact) {
                  story.add(fact);
                }
              }
            })
        .director(director)
        .build()
        .run();
  }

  private static void assertWell(SimResult result, long seed) {
    assertThat(result.spec().holds()).as("seed %d: %s", seed, result.spec()).isTrue();
    assertThat(result.unfinished()).as("seed %d", seed).isEmpty();
  }

  private long count(Class<? extends MutexFact> kind) {
    return story.stream().filter(kind::isInstance).count();
  }

  private View lastView() {
    View last = View.NONE;
    for (MutexFact event : story) {
      if (event instanceof MutexFact.Learned learned && learned.view().number() > last.number()) {
        last = learned.view();
      }
    }
    return last;
  }

  private ProcessId latestOf(RobotId robot) {
    TreeSet<ProcessId> ids = new TreeSet<>();
    story.stream().filter(e -> e.who().robot().equals(robot)).forEach(e -> ids.add(e.who()));
    return ids.last();
  }

  private static List<RobotId> named(String name, int count) {
    List<RobotId> names = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      names.add(new RobotId(name + i));
    }
    return List.copyOf(names);
  }

  /** A roadside unit: votes on views, but never requests. */
  private static final class Post extends LogicThread {
    private final long untilNs;

    Post(GlobalVarHolder gvh, long untilNs) {
      super(gvh);
      this.untilNs = untilNs;
      new Registration(gvh, XID, Participants.of(ROADSIDE));
    }

    @Override
    public List<Object> callStarL() {
      // Serves until all cars have had time to leave.
      sleep(untilNs / MS + 300_000);
      return returnResults();
    }
  }

  /** Registers, takes turns until the time is over, and unregisters, under all faults. */
  private static final class Car extends LogicThread {
    private final Registration reg;
    private final M_Mutex mux;
    private final Rng rng;
    private final long untilNs;
    private int turns;

    Car(GlobalVarHolder gvh, long untilNs) {
      super(gvh);
      this.untilNs = untilNs;
      reg = new Registration(gvh, XID, Participants.of(ROADSIDE));
      mux = new M_Mutex(gvh, XID, reg, TIMES);
      rng = gvh.plat.entropy.fork("car" + gvh.id.boot());
    }

    @Override
    public List<Object> callStarL() {
      if (gvh.id.boot() > 1) {
        mux.standsIn(List.of()); // a person has moved it meanwhile
      }
      register();
      while (gvh.plat.clock.nowNs() < untilNs || turns == 0) {
        takeTurn();
      }
      do {
        reg.unregister();
        await(() -> reg.isUnregistered() || reg.failed().get());
      } while (!reg.isUnregistered());
      return List.of(turns);
    }

    private void register() {
      while (!reg.mayRequest()) {
        reg.do_register();
        await(() -> reg.mayRequest() || reg.failed().get());
      }
    }

    private void takeTurn() {
      sleep(rng.nextLong(0, 500));
      List<String> some = new ArrayList<>(List.of("A", "B", "C", "D", "E", "F"));
      while (some.size() > 2) {
        some.remove(rng.nextInt(some.size()));
      }
      mux.do_mutex(some);
      await(() -> mux.crit().get() || mux.failed().get());
      if (mux.od_mutex()) {
        for (String section : some) {
          sleep(rng.nextLong(0, 1_000));
          mux.release(section);
        }
        turns++;
      } else if (mux.failure().get().mustRegister()) {
        register();
      }
    }
  }
}
