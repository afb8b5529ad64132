// Longer than 500 lines because each test is a small app on simulated robots.
package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.time.Time.NS_PER_MS;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.registration.Registration;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.sim.net.Latency;

/** The mutex on simulated robots, used by apps. */
class M_MutexTest {

  private static final String XID = "crossing";

  @Test
  void aClosedGroupTakesTurnsOverABadRadio() {
    for (long seed = 0; seed < 10; seed++) {
      SimResult result =
          run(5, seed, 0.3, gvh -> new Turns(gvh, new M_Mutex(gvh, XID, gvh.id.participants()), 5));
      assertThat(result.isFinished()).as("seed %d", seed).isTrue();
      assertThat(result.spec().holds()).as("seed %d: %s", seed, result.spec()).isTrue();
      assertThat(result.spec().checks(MutexSpec.EXCLUSIVE)).isEqualTo(25);
    }
  }

  @Test
  void robotsThatRegisterAndUnregisterAgainAndAgainTakeTurnsOverABadRadio() {
    for (long seed = 0; seed < 10; seed++) {
      SimResult result = run(4, seed, 0.2, Registered::new);
      assertThat(result.unfinished()).as("seed %d", seed).isEmpty();
      assertThat(result.spec().holds()).as("seed %d: %s", seed, result.spec()).isTrue();
      assertThat(result.spec().checks(MutexSpec.EXCLUSIVE)).isEqualTo(4 * Registered.ROUNDS * 2);
    }
  }

  @Test
  void anUnregisteredRobotsRequestFailsAtOnce() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              Registration reg = new Registration(gvh, XID);
              M_Mutex mux = new M_Mutex(gvh, XID, reg);
              return new Script(
                  gvh,
                  script -> {
                    mux.do_mutex(List.of("A"));
                    return List.of(mux.failed().get(), mux.failure().get(), mux.crit().get());
                  });
            });
    assertThat(result.results().values())
        .containsExactly(List.of(true, MutexFailure.NOT_REGISTERED, false));
  }

  @Test
  void theMembershipIsTheRegistrationOfTheSameId() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              Registration reg = new Registration(gvh, XID);
              M_Mutex mux = new M_Mutex(gvh, XID);
              return new Script(
                  gvh,
                  script -> {
                    mux.do_mutex(List.of("A"));
                    MutexFailure unregistered = mux.failure().get();
                    reg.do_register();
                    script.awaits(() -> reg.getList() != null);
                    mux.do_mutex(List.of("A"));
                    script.awaits(mux::od_mutex);
                    return List.of(unregistered);
                  });
            });
    assertThat(result.results().values()).containsExactly(List.of(MutexFailure.NOT_REGISTERED));
  }

  @Test
  void theAbsenceOfARegistrationOfThisIdIsRefused() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              new Registration(gvh, "another");
              String message = messageOf(() -> new M_Mutex(gvh, XID));
              return new Script(gvh, script -> List.of(message));
            });
    assertThat(result.results().values())
        .containsExactly(
            List.of(
                "mutex/crossing: this robot has no registration/crossing: expected one, created"
                    + " before, or a list of participants"));
  }

  @Test
  void aRequestThatNeedsAnAbsentRobotFailsAtItsDeadline() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              Participants both = Participants.of(gvh.id.name(), new RobotId("nobody"));
              MutexTimes times = MutexTimes.DEFAULT.withDeadlineMs(3_000);
              M_Mutex mux = new M_Mutex(gvh, XID, M_Mutex.closedGroup(gvh, both), times);
              return new Script(
                  gvh,
                  script -> {
                    mux.do_mutex(List.of("A"), both);
                    script.awaits(() -> mux.failed().get());
                    return List.of(gvh.plat.clock.nowNs() / NS_PER_MS, mux.failure().get());
                  });
            });
    assertThat(result.results().values()).containsExactly(List.of(3_000L, MutexFailure.DEADLINE));
  }

  @Test
  void aWithdrawnRequestFailsAndTheNextOneIsServed() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              M_Mutex mux = new M_Mutex(gvh, XID, gvh.id.participants());
              return new Script(
                  gvh,
                  script -> {
                    mux.withdraw();
                    boolean failedBefore = mux.failed().get();
                    mux.do_mutex(List.of("A", "B"));
                    mux.withdraw();
                    mux.release("A");
                    return List.of(failedBefore, mux.od_mutex(), mux.held());
                  });
            });
    assertThat(result.results().values())
        .containsExactly(List.of(false, true, Sections.copyOf(List.of("B"))));
  }

  @Test
  void whatIsShownIsOfTheLatestRequest() {
    SimResult result =
        run(
            1,
            1,
            0,
            gvh -> {
              ScriptedViews views = new ScriptedViews(gvh.id.freshProcess());
              M_Mutex mux = new M_Mutex(gvh, XID, views);
              return new Script(
                  gvh,
                  script -> {
                    mux.do_mutex(List.of("A"));
                    MutexFailure before = mux.failure().get();
                    views.admit(views.me());
                    mux.do_mutex(List.of("A"));
                    MutexFailure after = mux.failure().get();
                    mux.release("A");
                    return List.of(before, after, mux.crit().get());
                  });
            });
    assertThat(result.results().values())
        .containsExactly(List.of(MutexFailure.NOT_REGISTERED, MutexFailure.NONE, false));
  }

  @Test
  void aClosedMutexHasWithdrawnAndNeitherRequestsNorAnswers() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          boolean closes = gvh.id.name().equals(new RobotId("bot0"));
          M_Mutex mux =
              new M_Mutex(
                  gvh,
                  XID,
                  M_Mutex.closedGroup(gvh, gvh.id.participants()),
                  MutexTimes.DEFAULT.withDeadlineMs(3_000));
          return new Script(
              gvh,
              script -> {
                if (!closes) {
                  script.sleeps(5_000);
                }
                mux.do_mutex(List.of("A"));
                if (!closes) {
                  script.awaits(() -> mux.od_mutex() || mux.failed().get());
                  return List.of(mux.failure().get());
                }
                mux.close();
                String closed = "mutex/crossing is closed";
                assertThat(messageOf(() -> mux.do_mutex(List.of("A")))).isEqualTo(closed);
                assertThat(messageOf(mux::withdraw)).isEqualTo(closed);
                assertThat(messageOf(() -> mux.standsIn(List.of("A")))).isEqualTo(closed);
                script.sleeps(20_000);
                return List.of(mux.failure().get());
              });
        };
    assertThat(run(2, 1, 0, app).results())
        .containsEntry(new RobotId("bot0"), List.of(MutexFailure.WITHDRAWN))
        .containsEntry(new RobotId("bot1"), List.of(MutexFailure.DEADLINE));
  }

  @Test
  void aRobotThatUnregistersRequestsNothing() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          Registration reg = new Registration(gvh, XID);
          M_Mutex before = new M_Mutex(gvh, XID, reg);
          return new Script(
              gvh,
              script -> {
                reg.do_register();
                script.awaits(reg::mayRequest);
                reg.unregister();
                before.do_mutex(List.of("A"));
                return List.of(before.failure().get(), before.od_mutex());
              });
        };
    assertThat(run(1, 1, 0, app).results().values())
        .containsExactly(List.of(MutexFailure.NOT_REGISTERED, false));
  }

  @Test
  void aRobotThatRegistersAgainAnswersForItsOlderIds() {
    SimResult result = run(1, 1, 0, gvh -> withScriptedViews(gvh, false));
    assertThat(result.results().values())
        .containsExactly(List.of(Sections.copyOf(List.of("B")), false));
  }

  @Test
  void anOlderIdKeepsItsFences() {
    ProcessId older = ProcessId.first(new RobotId("bot0"), 1);
    ProcessId asker = ProcessId.first(new RobotId("bot1"), 1);
    ProcessId suspect = ProcessId.first(new RobotId("bot1"), 2);
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          if (gvh.id.name().equals(new RobotId("bot0"))) {
            ScriptedViews views = new ScriptedViews(gvh.id.freshProcess());
            new M_Mutex(gvh, XID, views);
            return new Script(
                gvh,
                script -> {
                  views.admit(views.me());
                  script.sleeps(5_000);
                  views.admit(gvh.id.freshProcess());
                  script.sleeps(5_000);
                  return List.of();
                });
          }
          List<Object> heard = new ArrayList<>();
          Endpoint<MutexMessage> endpoint =
              gvh.comms.open(
                  new Channel<>("mutex", XID, MutexMessage.SHAPE), (from, m) -> heard.add(m));
          return new Script(
              gvh,
              script -> {
                script.sleeps(1_000);
                endpoint.send(older.robot(), new MutexMessage.FenceQ(asker, older, suspect, 1));
                script.sleeps(6_000);
                for (ProcessId id : List.of(suspect, asker)) {
                  endpoint.send(
                      older.robot(),
                      new MutexMessage.Req(id, older, 1, 1, 1, Sections.copyOf(List.of("A"))));
                }
                script.sleeps(2_000);
                return heard;
              });
        };
    assertThat(run(2, 1, 0, app).results().get(new RobotId("bot1")))
        .containsExactly(
            new MutexMessage.Fence(older, asker, suspect, Sections.NONE),
            new MutexMessage.Ok(older, asker, 1));
  }

  @Test
  void sectionsOfAnOlderIdAreReleasedFirst() {
    SimResult result = run(1, 1, 0, gvh -> withScriptedViews(gvh, true));
    assertThat(result.results().values())
        .containsExactly(
            List.of(
                "mutex/crossing: do_mutex of [B] while holding [A]",
                Sections.copyOf(List.of("A")),
                Sections.copyOf(List.of("B")),
                false));
  }

  /** One robot whose second id finds its first id still in the view, and asks it. */
  private static LogicThread withScriptedViews(GlobalVarHolder gvh, boolean holding) {
    ScriptedViews views = new ScriptedViews(gvh.id.freshProcess());
    M_Mutex mux = new M_Mutex(gvh, XID, views);
    return new Script(
        gvh,
        script -> {
          List<Object> results = new ArrayList<>();
          views.admit(views.me());
          if (holding) {
            mux.do_mutex(List.of("A"));
          }
          views.admit(gvh.id.freshProcess());
          if (holding) {
            results.add(messageOf(() -> mux.do_mutex(List.of("B"))));
            results.add(mux.held());
            mux.release("A");
          }
          mux.do_mutex(List.of("B"));
          script.awaits(() -> mux.od_mutex() || mux.failed().get());
          results.add(mux.held());
          results.add(mux.failed().get());
          return results;
        });
  }

  private static String messageOf(Runnable wrong) {
    try {
      wrong.run();
      return "nothing wrong";
    } catch (IllegalStateException e) {
      return String.valueOf(e.getMessage());
    }
  }

  @Test
  void wrongUseEndsTheRunWithAMessage() {
    assertFails(
        "has this instance already", (gvh, mux) -> new M_Mutex(gvh, XID, gvh.id.participants()));
    assertFails("do_mutex of [A] while CRITICAL", (gvh, mux) -> mux.do_mutex(List.of("A")));
    assertFails("section 'a b'", (gvh, mux) -> mux.release("a b"));
    assertFails("release of [B] while holding [A]", (gvh, mux) -> mux.release("B"));
    assertFails(
        "expected bot0 among them",
        (gvh, mux) -> mux.do_mutex(List.of("A"), Participants.of(new RobotId("bot1"))));
    assertFails(
        "cannot exclude bot7, which is not in the group [bot0]",
        (gvh, mux) ->
            mux.do_mutex(List.of("B"), Participants.of(new RobotId("bot0"), new RobotId("bot7"))));
    assertFails(
        "mutex/crossing is closed",
        (gvh, mux) -> {
          mux.close();
          mux.close();
          mux.release("A");
        });
  }

  @Test
  void aShortParticipantListDoesNotNarrowExclusion() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          M_Mutex mux = new M_Mutex(gvh, XID, gvh.id.participants());
          return new Script(
              gvh,
              script -> {
                for (int i = 0; i < 5; i++) {
                  mux.do_mutex(List.of("A"), Participants.of(gvh.id.name()));
                  script.awaits(mux::od_mutex);
                  script.sleeps(50);
                  mux.release("A");
                }
                return List.of();
              });
        };
    SimResult result = run(3, 1, 0.1, app);
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.spec().checks(MutexSpec.EXCLUSIVE)).isEqualTo(15);
  }

  @Test
  void unregisteringWhileHoldingIsRefusedBeforeAnyMessage() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          Registration reg = new Registration(gvh, XID);
          M_Mutex mux = new M_Mutex(gvh, XID, reg);
          return new Script(
              gvh,
              script -> {
                reg.do_register();
                script.awaits(() -> reg.ts() > 0);
                mux.do_mutex(List.of("A"));
                script.awaits(mux::od_mutex);
                List<Object> told = new ArrayList<>();
                told.add(messageOf(reg::unregister));
                script.sleeps(5_000);
                told.add(reg.mayRequest());
                mux.release("A");
                reg.unregister();
                script.awaits(reg::isUnregistered);
                return told;
              });
        };
    assertThat(run(1, 1, 0, app).results().values())
        .containsExactly(
            List.of("mutex/crossing: unregister while holding [A]: release it first", true));
  }

  @Test
  void unregisteringEndsAWaitingRequestBeforeOthersForgetIt() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          Registration reg = new Registration(gvh, XID);
          M_Mutex mux = new M_Mutex(gvh, XID, reg);
          boolean first = gvh.id.name().equals(new RobotId("bot0"));
          return new Script(
              gvh,
              script -> {
                reg.do_register();
                script.awaits(reg::mayRequest);
                script.sleeps(first ? 0 : 5_000);
                mux.do_mutex(List.of("A"));
                script.sleeps(2_000);
                if (!first) {
                  reg.unregister();
                  return List.of(mux.od_mutex(), mux.failure().get());
                }
                script.sleeps(20_000);
                return List.of(mux.od_mutex(), mux.failure().get());
              });
        };
    SimResult result = run(2, 1, 0, app);
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.results().values())
        .containsExactly(List.of(true, MutexFailure.NONE), List.of(false, MutexFailure.REMOVED));
  }

  @Test
  void twoInstancesAreIndependent() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          Registration north = new Registration(gvh, "north");
          Registration south = new Registration(gvh, "south");
          M_Mutex mux = new M_Mutex(gvh, "north", north);
          M_Mutex other = new M_Mutex(gvh, "south", south);
          boolean first = gvh.id.name().equals(new RobotId("bot0"));
          return new Script(
              gvh,
              script -> {
                north.do_register();
                south.do_register();
                script.awaits(() -> north.mayRequest() && south.mayRequest());
                (first ? mux : other).do_mutex(List.of("A"));
                script.awaits(() -> first ? mux.od_mutex() : other.od_mutex());
                script.sleeps(10_000);
                return List.of(mux.held().size(), other.held().size());
              });
        };
    assertThat(run(2, 3, 0.2, app).results().values())
        .containsExactly(List.of(1, 0), List.of(0, 1));
  }

  @Test
  void aRegistrationServesOneMutex() {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          Registration reg = new Registration(gvh, XID);
          new M_Mutex(gvh, XID, reg);
          return new Script(
              gvh, script -> List.of(messageOf(() -> new M_Mutex(gvh, "other", reg))));
        };
    assertThat(run(1, 1, 0, app).results().values())
        .containsExactly(
            List.of(
                "registration/crossing has a mutex already: give each one a registration of its"
                    + " own"));
  }

  private interface Wrong {
    void use(GlobalVarHolder gvh, M_Mutex mux);
  }

  private static void assertFails(String message, Wrong wrong) {
    Function<GlobalVarHolder, LogicThread> app =
        gvh -> {
          M_Mutex mux = new M_Mutex(gvh, XID, gvh.id.participants());
          return new Script(
              gvh,
              script -> {
                mux.do_mutex(List.of("A"));
                wrong.use(gvh, mux);
                return List.of();
              });
        };
    assertThatThrownBy(() -> run(1, 1, 0, app))
        .isInstanceOf(SimulationFailed.class)
        .rootCause()
        .hasMessageContaining(message);
  }

  private static SimResult run(
      int robots, long seed, double loss, Function<GlobalVarHolder, ? extends LogicThread> app) {
    SimSettings settings =
        SimSettings.builder()
            .set(Setting.MESSAGE_DELAY, new Latency.Uniform(10 * NS_PER_MS, 200 * NS_PER_MS))
            .set(Setting.MESSAGE_LOSS, loss)
            .duration(Duration.ofMinutes(20))
            .build();
    return Simulation.builder()
        .robots(robots, app)
        .seed(seed)
        .settings(settings)
        .monitor(MutexSpec::new)
        .build()
        .run();
  }

  /** An app that consists of one lambda. */
  private static final class Script extends LogicThread {
    private final Function<Script, List<Object>> lines;

    Script(GlobalVarHolder gvh, Function<Script, List<Object>> lines) {
      super(gvh);
      this.lines = lines;
    }

    @Override
    public List<Object> callStarL() {
      return lines.apply(this);
    }

    void sleeps(long ms) {
      sleep(ms);
    }

    void awaits(BooleanSupplier condition) {
      await(condition);
    }
  }

  /** Requests some of A to D, uses them and releases them one by one; repeats this. */
  private static class Turns extends LogicThread {
    private final M_Mutex mux;
    private final int turns;
    private final Rng rng;

    Turns(GlobalVarHolder gvh, M_Mutex mux, int turns) {
      super(gvh);
      this.mux = mux;
      this.turns = turns;
      this.rng = gvh.plat.entropy.fork("turns");
    }

    @Override
    public List<Object> callStarL() {
      for (int turn = 0; turn < turns; turn++) {
        takeTurn();
      }
      return returnResults();
    }

    final void takeTurn() {
      sleep(rng.nextLong(0, 300));
      List<String> some = new ArrayList<>(List.of("A", "B", "C", "D"));
      some.removeIf(name -> rng.nextBoolean(0.5));
      if (some.isEmpty()) {
        some.add("A");
      }
      mux.do_mutex(some, gvh.id.participants());
      await(() -> mux.crit().get() || mux.failed().get());
      if (!mux.od_mutex()) {
        throw new IllegalStateException("failed: " + mux.failure().get());
      }
      for (String section : some) {
        sleep(rng.nextLong(0, 100));
        mux.release(section);
      }
    }
  }

  /** Registers, takes two turns and unregisters; repeats this. */
  private static final class Registered extends LogicThread {
    static final int ROUNDS = 3;

    private final Registration reg;
    private final Turns turns;

    Registered(GlobalVarHolder gvh) {
      super(gvh);
      reg = new Registration(gvh, XID);
      turns = new Turns(gvh, new M_Mutex(gvh, XID, reg), 0);
    }

    @Override
    public List<Object> callStarL() {
      for (int round = 0; round < ROUNDS; round++) {
        do {
          reg.do_register();
          await(() -> reg.mayRequest() || reg.failed().get());
        } while (!reg.mayRequest());
        turns.takeTurn();
        turns.takeTurn();
        do {
          reg.unregister();
          await(() -> reg.isUnregistered() || reg.failed().get());
        } while (!reg.isUnregistered());
      }
      return returnResults();
    }
  }
}
