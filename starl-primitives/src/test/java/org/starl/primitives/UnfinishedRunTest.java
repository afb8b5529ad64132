package org.starl.primitives;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.election.Election;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.registration.Registration;
import org.starl.shape.Shapes;
import org.starl.sim.Diagnosis;
import org.starl.sim.Diagnosis.Kind;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** A run that does not finish says why: twelve planted faults. */
class UnfinishedRunTest {

  /** An app whose body is a lambda, with the waits of an app. */
  private static final class App extends LogicThread {
    private final Consumer<App> body;

    App(GlobalVarHolder gvh, Consumer<App> body) {
      super(gvh);
      this.body = body;
    }

    @Override
    public List<Object> callStarL() {
      body.accept(this);
      return returnResults();
    }

    GlobalVarHolder gvh() {
      return gvh;
    }

    boolean is(int number) {
      return gvh.id.name().name().equals("bot" + number);
    }

    void waitFor(Election election) {
      election.do_election();
      await("a leader", election::isLeader);
    }

    void enter(M_Mutex mutex, String section) {
      mutex.do_mutex(List.of(section));
      await(() -> mutex.crit().get());
    }

    void pause(long ms) {
      sleep(ms);
    }

    void waitFor(DistributedPathPlanning paths) {
      paths.goTo(new ItemPosition("goal", 0, 1000));
      await("at the goal", () -> !paths.isUnderWay());
    }

    void waitForAFix() {
      await(gvh.gps::hasFix);
    }

    void waitForOrders() {
      await("orders of the leader", () -> false);
    }

    void waitForEver() {
      await("a sign that never comes", () -> false);
    }

    void poll(Barrier barrier) {
      while (!barrier.outcome().get().isTold()) {
        sleep(100);
      }
    }

    void waitFor(SetAgreement<String> agreement) {
      await(() -> agreement.decided().get().toString().startsWith("never"));
    }

    void waitUntilRegistered(Registration registration) {
      await("registered", registration::mayRequest);
    }

    void driveTo(double xMm, double yMm) {
      gvh.plat.moat.doMove(new ItemPosition("goal", xMm, yMm));
      await("arrival", () -> gvh.plat.moat.motionflag().get().toString().equals("DONE"));
    }
  }

  private static Simulation.Builder simulation(int robots, Consumer<App> body) {
    Simulation.Builder builder =
        Simulation.builder()
            .name("planted")
            .seed(1)
            .settings(SimSettings.builder().set("duration", "40s").build())
            .observer(new SimObserver() {});
    for (int i = 0; i < robots; i++) {
      RobotId id = new RobotId("bot" + i);
      builder.robot(new RobotSpec(id, new Pose(0, 1000 * i, 0), true, gvh -> new App(gvh, body)));
    }
    return builder;
  }

  private static Diagnosis run(int robots, Consumer<App> body, Consumer<Simulation.Builder> more) {
    Simulation.Builder builder = simulation(robots, body);
    more.accept(builder);
    Diagnosis diagnosis = builder.build().run().diagnosis();
    assertThat(diagnosis.kind()).isNotEqualTo(Kind.FINISHED);
    if (Boolean.getBoolean("starl.test.print")) {
      diagnosis.lines().forEach(System.out::println);
    }
    return diagnosis;
  }

  private static Diagnosis run(int robots, Consumer<App> body) {
    return run(robots, body, builder -> {});
  }

  private static Consumer<Simulation.Builder> crash(int robot, int atSeconds) {
    return builder ->
        builder.director(control ->
            control.at(
                atSeconds * 1_000_000_000L, () -> control.crash(new RobotId("bot" + robot))));
  }

  @Test
  void twoMutexesTakenInDifferentOrderAreADeadlock() {
    Diagnosis diagnosis =
        run(
            2,
            app -> {
              M_Mutex left = new M_Mutex(app.gvh(), "left", app.gvh().id.participants());
              M_Mutex right = new M_Mutex(app.gvh(), "right", app.gvh().id.participants());
              app.enter(app.is(0) ? left : right, "S");
              app.pause(2_000);
              app.enter(app.is(0) ? right : left, "S");
            });
    assertThat(diagnosis.cause())
        .isEqualTo("deadlock: robots wait in a circle: bot0 -> bot1 -> bot0");
    assertThat(diagnosis.lines())
        .anyMatch(line -> line.contains("mutex/left: holds [S]"))
        .anyMatch(line -> line.contains("mutex/right: requests [S]; answers missing from [bot1]"))
        .anyMatch(line -> line.matches(".*bot0 waits at UnfinishedRunTest.java:\\d+ .enter. .*"));
  }

  @Test
  void aHolderThatNeverReleasesIsTheCause() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              M_Mutex mutex = new M_Mutex(app.gvh(), "door", app.gvh().id.participants());
              if (!app.is(1)) {
                app.pause(1_000);
              }
              app.enter(mutex, "D");
              app.waitForEver();
            });
    assertThat(diagnosis.cause()).contains("bot1 mutex/door: holds [D]");
    assertThat(diagnosis.lines()).anyMatch(line -> line.endsWith("for: a sign that never comes"));
  }

  @Test
  void aRobotThatDoesNotArriveAtABarrierIsTheCause() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              Barrier barrier = new Barrier(app.gvh(), "meet");
              if (app.is(2)) {
                app.waitForEver();
              }
              barrier.arrive();
              app.poll(barrier);
            });
    assertThat(diagnosis.cause()).contains("bot2 waits at UnfinishedRunTest.java");
    assertThat(diagnosis.lines())
        .anyMatch(line -> line.contains("waits in generation 1 for arrivals from [bot2]"));
  }

  @Test
  void aWallInTheWayIsNamed() {
    Diagnosis diagnosis =
        run(
            1,
            app -> app.driveTo(2000, 0),
            builder ->
                builder.obstacles(
                    Obstacles.of(Obstacle.wall(new Point(1000, -500), new Point(1000, 500)))));
    assertThat(diagnosis.lines()).anyMatch(line -> line.contains("motion: failed: "));
    assertThat(diagnosis.cause()).contains("motion failed");
  }

  @Test
  void anElectionWithoutAMajorityNamesTheMissingVoters() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              Election election = new Election(app.gvh(), "chief");
              app.pause(5_000);
              app.waitFor(election);
            },
            builder ->
                builder.director(control ->
                    control.at(
                        1_000_000_000L,
                        () -> {
                          control.crash(new RobotId("bot1"));
                          control.crash(new RobotId("bot2"));
                        })));
    assertThat(diagnosis.down()).hasSize(2);
    assertThat(diagnosis.lines())
        .anyMatch(line -> line.contains("bot0 waits at") && line.endsWith("for: a leader"));
    assertThat(diagnosis.cause())
        .contains("bot0 election/chief: failed in term 1: no majority answered");
  }

  @Test
  void aCrashedHolderIsTheCause() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              M_Mutex mutex = new M_Mutex(app.gvh(), "door", app.gvh().id.participants());
              if (!app.is(1)) {
                app.pause(1_000);
              }
              app.enter(mutex, "D");
              app.pause(100_000);
            },
            crash(1, 2));
    assertThat(diagnosis.cause()).contains("2 robots wait for bot1, which has crashed");
  }

  @Test
  void aRunWithoutAnEventLeftIsADeadlock() {
    Diagnosis diagnosis =
        run(
            0,
            app -> {},
            builder ->
                builder.robot(
                    new RobotSpec(
                        new RobotId("bot0"),
                        new Pose(0, 0, 0),
                        false,
                        gvh -> new App(gvh, App::waitForEver))));
    assertThat(diagnosis.kind()).isEqualTo(Kind.NO_EVENT_LEFT);
    assertThat(diagnosis.cause())
        .startsWith("deadlock: no event is left, so no robot can go on; bot0 waits at ")
        .contains("a sign that never comes");
  }

  @Test
  void aRobotThatStillWorksIsSlow() {
    Diagnosis diagnosis =
        run(
            1,
            app -> {
              GvhCell<Integer> rounds = app.gvh().variable(Var.of("rounds", Shapes.INT), 0);
              while (rounds.get() >= 0) {
                app.pause(500);
                rounds.set(rounds.get() + 1);
              }
            });
    assertThat(diagnosis.kind()).isEqualTo(Kind.ACTIVE);
    assertThat(diagnosis.cause()).startsWith("slow or a livelock");
    assertThat(diagnosis.lines()).anyMatch(line -> line.contains("app.rounds=80"));
  }

  @Test
  void aRegistrationWithoutAMajorityNamesTheMissingAcceptors() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              Registration registration = new Registration(app.gvh(), "list");
              app.pause(5_000);
              registration.do_register();
              app.waitUntilRegistered(registration);
            },
            builder ->
                builder.director(control ->
                    control.at(
                        1_000_000_000L,
                        () -> {
                          control.crash(new RobotId("bot1"));
                          control.crash(new RobotId("bot2"));
                        })));
    assertThat(diagnosis.lines()).anyMatch(line -> line.endsWith("for: registered"));
    assertThat(diagnosis.cause())
        .contains("bot0 registration/list: failed: no majority of the acceptors answered");
  }

  /** A robot must have its section 10 s after its request. */
  private static final class Served implements Monitor {
    private final Within<RobotId> deadline = new Within<>(10_000_000_000L);

    @Override
    public List<String> lemmas() {
      return List.of("served");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      deadline.expire(
          event.timeNs(),
          (robot, sinceNs, deadlineNs) ->
              report.overdue("served", deadlineNs, List.of(robot), "late"));
      if (event instanceof TraceEvent.Action action && action.name().equals("do_mutex")) {
        deadline.start(event.robot(), event.timeNs());
      } else if (event instanceof TraceEvent.Action action && action.name().equals("od_mutex")) {
        deadline.stop(event.robot());
      }
    }
  }

  @Test
  void aMissedDeadlineIsDiagnosedWhenItIsMissed() {
    SimResult result =
        simulation(
                3,
                app -> {
                  M_Mutex mutex = new M_Mutex(app.gvh(), "door", app.gvh().id.participants());
                  app.pause(app.is(1) ? 0 : 1_000);
                  app.enter(mutex, "D");
                  app.pause(app.is(1) ? 15_000 : 100);
                  mutex.release("D");
                  app.pause(5_000);
                })
            .monitor(Served::new)
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.diagnoses()).hasSize(1);
    result
        .diagnoses()
        .forEach((violation, diagnosis) -> {
          assertThat(violation.timeNs()).isEqualTo(11_000_000_000L);
          assertThat(diagnosis.cause()).contains("bot1 mutex/door: holds [D]");
          assertThat(diagnosis.graph().of(new RobotId("bot0"))).contains(new RobotId("bot1"));
          assertThat(result.diagnosis(violation)).isEqualTo(diagnosis);
        });
  }

  /** No robot may ask for a section. */
  private static final class Modest implements Monitor {
    @Override
    public List<String> lemmas() {
      return List.of("modest");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof TraceEvent.Action action && action.name().equals("do_mutex")) {
        report.violated("modest", event.timeNs(), List.of(event.robot()), "asks");
      }
    }
  }

  @Test
  void aViolationTellsWhereItsRobotRunsOrWaits() {
    SimResult result =
        simulation(
                2,
                app -> {
                  M_Mutex mutex = new M_Mutex(app.gvh(), "door", app.gvh().id.participants());
                  app.pause(1_000);
                  app.enter(mutex, "D");
                  mutex.release("D");
                })
            .monitor(Modest::new)
            .build()
            .run();
    assertThat(result.diagnoses()).hasSize(1);
    assertThat(result.diagnosis(result.spec().violations().get(0)).lines())
        .first()
        .asString()
        .matches("  bot[01] runs at UnfinishedRunTest.java:\\d+ .enter.");
  }

  @Test
  void theRobotWhoseTubeIsInTheWayIsNamed() {
    Diagnosis diagnosis =
        run(
            2,
            app -> {
              DistributedPathPlanning paths =
                  new DistributedPathPlanning(
                      app.gvh(),
                      "floor",
                      new OptimalPlanner(),
                      new Rectangle(-3000, -3000, 3000, 4000));
              app.waitForAFix();
              if (app.is(1)) {
                app.waitForEver();
              }
              app.waitFor(paths);
            });
    assertThat(diagnosis.cause()).contains("bot1 waits at UnfinishedRunTest.java");
    assertThat(diagnosis.graph().of(new RobotId("bot0"))).containsExactly(new RobotId("bot1"));
    assertThat(diagnosis.lines())
        .anyMatch(line -> line.matches(".*refused [0-9]+ times; needs room from .bot1."));
  }

  @Test
  void aLeaderThatHasCrashedIsNamed() {
    Diagnosis diagnosis =
        run(
            3,
            app -> {
              Election election = new Election(app.gvh(), "chief");
              if (app.is(2)) {
                app.waitFor(election);
                app.waitForEver();
              }
              app.waitForOrders();
            },
            crash(2, 5));
    assertThat(diagnosis.cause())
        .startsWith("stuck: nothing has changed since ")
        .endsWith(" for: orders of the leader; crashed: [bot2]");
  }

  @Test
  void ofManyRobotsTwentyAreExplained() {
    Diagnosis diagnosis =
        run(
            33,
            app -> {
              M_Mutex mutex = new M_Mutex(app.gvh(), "door", app.gvh().id.participants());
              if (!app.is(31)) {
                app.pause(1_000);
              }
              app.enter(mutex, "D");
              app.waitForEver();
            });
    assertThat(diagnosis.robots()).hasSize(Diagnosis.MAX_EXPLAINED);
    assertThat(diagnosis.robots()).anyMatch(robot -> robot.robot().name().equals("bot31"));
    assertThat(diagnosis.cause()).contains("bot31 mutex/door: holds [D]");
    assertThat(diagnosis.lines())
        .contains("  and 13 more unfinished robots")
        .noneMatch(line -> line.contains("bot30 waits at "));
  }

  @Test
  void aMisreadAgreementShowsItsVariables() {
    Diagnosis diagnosis =
        run(
            2,
            app -> {
              SetAgreement<String> agreement =
                  new SetAgreement<>(app.gvh(), "colour", Codec.text());
              agreement.propose("red");
              app.waitFor(agreement);
            });
    assertThat(diagnosis.kind()).isEqualTo(Kind.STUCK);
    assertThat(diagnosis.lines()).anyMatch(line -> line.contains("agreement/colour.decided="));
  }
}
