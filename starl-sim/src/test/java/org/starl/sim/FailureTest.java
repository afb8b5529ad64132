package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.sim.Failure.Culprit;
import org.starl.sim.Failure.Kind;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultPlan;
import org.starl.spec.Require;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/** The description of what went wrong. */
class FailureTest {

  private static final long S = 1_000_000_000;
  private static final RobotId BOT = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");
  private static final List<String> COMMANDS = List.of("replay: again");
  private static final Region ZONE = new Circle(new Point(5000, 5000), 100);

  /** Waits until a time, then ends. */
  private static final class Waiting extends LogicThread {
    private final int untilMs;

    Waiting(GlobalVarHolder gvh, int untilMs) {
      super(gvh);
      this.untilMs = untilMs;
    }

    @Override
    public List<Object> callStarL() {
      sleep(untilMs);
      return returnResults();
    }
  }

  private static Simulation.Builder two(int untilMs, String... faults) {
    return Simulation.builder()
        .robot(new RobotSpec(BOT, new Pose(0, 0, 0), true, gvh -> new Waiting(gvh, untilMs)))
        .robot(new RobotSpec(OTHER, new Pose(2000, 0, 0), true, gvh -> new Waiting(gvh, untilMs)))
        .faults(new FaultPlan(List.of(faults).stream().map(FaultGrammar::parse).toList()))
        .commands(() -> COMMANDS)
        .observer(new SimObserver() {})
        .endNs(60 * S);
  }

  /** Without an agreeing fix for 30 s, a robot believes the fixes that contradict it. */
  private static SimResult late(String... faults) {
    return two(50_000, faults)
        .monitor(() -> Require.always("early", "it is before 40 s", run -> run.timeNs() < 40 * S))
        .build()
        .run();
  }

  private static Failure failure(SimResult result) {
    assertThat(result.failure()).isNotNull();
    return result.failure();
  }

  private static Culprit culprit(Failure failure, RobotId robot) {
    return failure.culprits().stream().filter(c -> c.robot().equals(robot)).findFirst().get();
  }

  @Test
  void aGoodRunHasNone() {
    SimResult good = two(8_000, "jump(bot0,600mm,at=2s)").build().run();
    assertThat(good.failure()).isNull();
    assertThat(good.faults()).hasSize(1);
  }

  @Test
  void aViolationNamesItsLemmaItsRobotsAndWhatTheyBelieved() {
    Failure failure = failure(late("jump(bot0,600mm,at=2s)"));
    assertThat(failure.kind()).isEqualTo(Kind.VIOLATED);
    assertThat(failure.lemma()).isEqualTo("early");
    assertThat(failure.sentence()).isEqualTo("it is before 40 s");
    assertThat(failure.atNs()).isBetween(40 * S, 40 * S + S / 20);
    assertThat(failure.robots()).containsExactly(BOT, OTHER);
    Deviation wrong = culprit(failure, BOT).deviation();
    assertThat(wrong.distanceMm()).isBetween(599.0, 601.0);
    assertThat(wrong.isFalse()).isTrue();
    assertThat(culprit(failure, OTHER).deviation()).isEqualTo(Deviation.NONE);
    assertThat(failure.cause())
        .contains("bot0 believed to be 600 mm from where it was")
        .contains("jump(bot0,600mm,at=2s) of bot0 from 2.000 s");
    assertThat(failure.commands()).isEqualTo(COMMANDS);
  }

  @Test
  void aFaultOfAnyRobotNamesTheRobotThatItDrew() {
    SimResult result = late("jump(any,600mm,at=2s)");
    RobotId drawn = result.faults().getFirst().robot();
    assertThat(List.of(BOT, OTHER)).contains(drawn);
    assertThat(culprit(failure(result), drawn).deviation().isFalse()).isTrue();
    assertThat(failure(result).cause()).contains("jump(any,600mm,at=2s) of " + drawn);
  }

  @Test
  void whatACrashedRobotBelievedIsForgottenAndItsRestartEndsTheFault() {
    SimResult result = late("jump(bot0,600mm,at=1s,for=34s)", "crash(bot0,at=36s,restart=1s)");
    assertThat(culprit(failure(result), BOT).deviation()).isEqualTo(Deviation.NONE);
    assertThat(result.faults())
        .extracting(InjectedFault::beganNs, InjectedFault::endedNs)
        .containsExactly(tuple(S, 35 * S), tuple(36 * S, 37 * S));
  }

  @Test
  void aRunThatHasNotFinishedTellsWhy() {
    Failure failure = failure(two(90_000, "crash(bot1,at=3s)").build().run());
    assertThat(failure.kind()).isEqualTo(Kind.UNFINISHED);
    assertThat(failure.atNs()).isEqualTo(60 * S);
    assertThat(failure.robots()).containsExactly(BOT);
    assertThat(failure.cause()).contains("FailureTest.java").contains("crash(bot1,at=3s) of bot1");
  }

  @Test
  void observersAreToldOfAnErrorThatEndsTheRun() {
    List<Failure> told = new ArrayList<>();
    Simulation.Builder run =
        two(100, "crash(bot1,at=20ms)")
            .robot(
                new RobotSpec(
                    new RobotId("bot2"),
                    new Pose(4000, 0, 0),
                    true,
                    gvh ->
                        new LogicThread(gvh) {
                          @Override
                          public List<Object> callStarL() {
                            sleep(50);
                            throw new IllegalStateException("no way on");
                          }
                        }))
            .observer(
                new SimObserver() {
                  @Override
                  public void wentWrong(Failure failure) {
                    told.add(failure);
                  }
                });
    assertThatThrownBy(() -> run.build().run()).isInstanceOf(SimulationFailed.class);
    Failure failure = told.getFirst();
    assertThat(told).hasSize(1);
    assertThat(failure.kind()).isEqualTo(Kind.FAILED);
    assertThat(failure.headline()).contains("bot2", "no way on");
    assertThat(failure.robots()).containsExactly(new RobotId("bot2"));
    assertThat(failure.faults()).hasSize(1);
    assertThat(failure.commands()).isEqualTo(COMMANDS);
  }

  @Test
  void observersAreToldOnceAndAfterTheViolation() {
    List<String> told = new ArrayList<>();
    SimObserver listener =
        new SimObserver() {
          @Override
          public void violated(SpecReport.Violation violation) {
            told.add("violated");
          }

          @Override
          public void wentWrong(Failure failure) {
            told.add(failure.kind().name());
          }
        };
    two(60_000)
        .monitor(() -> Require.neverTwoIn("alone", ZONE))
        .monitor(() -> Require.always("early", "before 5 s", run -> run.timeNs() < 5 * S))
        .monitor(() -> Require.always("soon", "before 6 s", run -> run.timeNs() < 6 * S))
        .observer(listener)
        .build()
        .run();
    assertThat(told).containsExactly("violated", "VIOLATED", "violated");
  }

  @Test
  void aRunWithoutFalseBeliefsTracesNone() {
    List<TraceEvent> beliefs = new ArrayList<>();
    SimObserver listener =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (event instanceof TraceEvent.Variable v && v.of(Deviation.VAR) != null) {
              beliefs.add(event);
            }
          }
        };
    two(50_000).observer(listener).build().run();
    assertThat(beliefs).isEmpty();
    two(50_000, "jump(bot0,600mm,at=2s)").observer(listener).build().run();
    assertThat(beliefs).hasSizeBetween(1, 4);
  }
}
