package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.ledger.LedgerOutcome.DONE;
import static org.starl.primitives.ledger.LedgerOutcome.LATE;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Ledgers of simulated robots that crash, are cut off, and come back. */
class LedgerSimTest {

  private static final TaskId ONE = new TaskId("orders", 1);

  /** A robot with a ledger of texts, which does what a test says. */
  private static final class Robot extends LogicThread {
    private final TaskLedger<String> ledger;
    private final Function<Robot, List<Object>> script;

    Robot(GlobalVarHolder gvh, Function<Robot, List<Object>> script) {
      super(gvh);
      this.script = script;
      ledger = new TaskLedger<>(gvh, "jobs", Shapes.TEXT);
    }

    @Override
    public List<Object> callStarL() {
      await(() -> ledger.ready().get());
      return script.apply(this);
    }

    GlobalVarHolder gvh() {
      return gvh;
    }

    boolean is(String robot, int boot) {
      return gvh.id.name().name().equals(robot) && gvh.id.boot() == boot;
    }

    LedgerOutcome told(LedgerCall call) {
      await(call::isDone);
      return call.outcome();
    }

    void pause(long ms) {
      sleep(ms);
    }

    void waitFor(BooleanSupplier condition) {
      await(condition);
    }

    void until(long ms) {
      pause(Math.max(0, ms - gvh.plat.clock.nowNs() / 1_000_000));
    }

    String held() {
      return ledger.held().get().toString();
    }
  }

  private final List<TraceEvent> events = new ArrayList<>();

  private SimResult run(Function<Robot, List<Object>> script, String... faults) {
    Simulation.Builder builder =
        Simulation.builder()
            .robots(3, gvh -> new Robot(gvh, script))
            .seed(5)
            .observer(
                new SimObserver() {
                  @Override
                  public void observed(TraceEvent event) {
                    events.add(event);
                  }
                })
            .monitor(LedgerSpec::new);
    for (String fault : faults) {
      builder.fault(fault);
    }
    SimResult result = builder.build().run();
    assertThat(result.isFinished()).as("%s", result.unfinished()).isTrue();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    return result;
  }

  private long installed() {
    return events.stream()
        .filter(event ->
            event instanceof Action action
                && action.fact() instanceof LedgerFact.Installed known
                && known.number() > 0)
        .count();
  }

  /** It lacks more decrees than the others keep: it gets the state, in several parts. */
  @Test
  void aRobotThatIsFarBehindGetsTheState() {
    SimResult result =
        run(
            robot -> {
              if (robot.is("bot0", 1)) {
                robot.until(3_000);
                for (int i = 1; i <= 80; i++) {
                  robot.told(robot.ledger.add(new TaskId("orders", i), "x".repeat(100) + i));
                }
              }
              robot.until(120_000);
              return List.of(robot.ledger.tasks().toString().length(), robot.ledger.tasks().size());
            },
            "partition(bot0+bot1|bot2,at=2s,until=90s)");
    assertThat(result.results().values().stream().distinct()).hasSize(1);
    assertThat(result.results().toString()).contains(", 80]");
    assertThat(installed()).isPositive();
  }

  /** No robot remembers anything but what it has stored. */
  @Test
  void nothingIsLostIfAllRobotsCrash() {
    SimResult result =
        run(
            robot -> {
              if (robot.is("bot0", 1)) {
                for (int i = 1; i <= 5; i++) {
                  robot.told(robot.ledger.add(new TaskId("orders", i), "order " + i));
                }
                robot.told(robot.ledger.claim(ONE));
                robot.told(robot.ledger.begin(ONE));
                robot.told(robot.ledger.finish(ONE));
              }
              robot.until(30_000);
              return List.of(
                  robot.ledger.tasks().keySet().toString(), robot.ledger.added("orders"));
            },
            "crash(all,at=10s,restart=2s,lose=unsynced)");
    assertThat(result.results().values())
        .containsOnly(List.of("[orders/2, orders/3, orders/4, orders/5]", 5L));
  }

  @Test
  void aRestartedRobotKnowsWhatItHasBegunAndHasNoOtherClaim() {
    TaskId two = new TaskId("orders", 2);
    SimResult result =
        run(
            robot -> {
              if (robot.is("bot0", 1)) {
                robot.told(robot.ledger.add(ONE, "one"));
                robot.told(robot.ledger.add(two, "two"));
                robot.told(robot.ledger.claim(ONE));
                robot.told(robot.ledger.begin(ONE));
                robot.told(robot.ledger.claim(two));
                robot.pause(60_000);
              }
              if (robot.is("bot0", 2)) {
                String held = robot.held();
                LedgerOutcome back = robot.told(robot.ledger.giveBack(ONE));
                return List.of(held, back, robot.told(robot.ledger.finish(ONE)), robot.held());
              }
              return List.of();
            },
            "crash(bot0,at=10s,restart=2s)");
    assertThat(result.results().toString()).contains("[[orders/1], LATE, DONE, []]");
  }

  @Test
  void withoutAMajorityACallEndsAtItsDeadline() {
    SimResult result =
        run(
            robot -> {
              robot.until(5_000);
              return List.of(robot.told(robot.ledger.add(ONE, "one")));
            },
            "crash(bot1,at=2s)",
            "crash(bot2,at=2s)");
    assertThat(result.results().toString()).contains("UNKNOWN");
  }

  @Test
  void aRobotThatDoesNotHoldATaskCannotGiveItBack() {
    SimResult result =
        run(robot -> {
          if (robot.is("bot0", 1)) {
            robot.told(robot.ledger.add(ONE, "one"));
            robot.told(robot.ledger.claim(ONE));
            robot.until(10_000);
            return List.of(robot.told(robot.ledger.begin(ONE)));
          }
          if (robot.is("bot1", 1)) {
            robot.until(5_000);
            return List.of(robot.told(robot.ledger.giveBack(ONE)));
          }
          return List.of();
        });
    assertThat(result.results().values()).containsExactly(List.of(DONE), List.of(DONE), List.of());
  }

  /** Its own clock tells a slow robot nothing: the log does. */
  @Test
  void aClaimantThatWasCutOffLearnsAtBeginThatItsClaimHasEnded() {
    SimResult result =
        run(
            robot -> {
              if (robot.is("bot0", 1)) {
                robot.told(robot.ledger.add(ONE, "one"));
                robot.told(robot.ledger.claim(ONE));
                robot.until(60_000);
                return List.of(robot.told(robot.ledger.begin(ONE)));
              }
              if (robot.is("bot1", 1)) {
                robot.until(5_000);
                robot.waitFor(
                    () -> robot.ledger.tasks().values().stream().anyMatch(LedgerTask::isOpen));
                return List.of(
                    robot.told(robot.ledger.claim(ONE)), robot.told(robot.ledger.begin(ONE)));
              }
              return List.of();
            },
            "partition(bot0|bot1+bot2,at=4s,until=50s)");
    assertThat(result.results().values())
        .containsExactly(List.of(LATE), List.of(DONE, DONE), List.of());
  }

  @Test
  void aTaskThatADeadRobotHasBegunStaysUntilItIsReopened() {
    SimResult result =
        run(
            robot -> {
              if (robot.is("bot0", 1)) {
                robot.told(robot.ledger.add(ONE, "one"));
                robot.told(robot.ledger.claim(ONE));
                robot.told(robot.ledger.begin(ONE));
                robot.pause(60_000);
              }
              if (!robot.is("bot1", 1)) {
                return List.of();
              }
              robot.until(40_000);
              LedgerOutcome early = robot.told(robot.ledger.claim(ONE));
              boolean isSilent = robot.ledger.isSilent(new RobotId("bot0"));
              return List.of(
                  early,
                  isSilent,
                  robot.told(robot.ledger.reopen(ONE)),
                  robot.told(robot.ledger.claim(ONE)));
            },
            "crash(bot0,at=10s,restart=60s)");
    assertThat(result.results().toString()).contains("[LATE, true, DONE, DONE]");
  }

  /** bot2 bids least; when it has crashed, its old bid is in no robot's way. */
  @Test
  void theCheapestBidderClaimsTheTaskAndADeadOneLosesIt() {
    SimResult result =
        run(
            robot -> {
              Auction auction = new Auction(robot.gvh(), "jobs", 600);
              int cost = 10 - robot.gvh().id.name().name().charAt(3);
              if (robot.is("bot0", 1)) {
                robot.told(robot.ledger.add(ONE, "one"));
              }
              List<Object> outcomes = new ArrayList<>();
              robot.waitFor(() -> !robot.ledger.tasks().isEmpty());
              robot.until(5_000);
              while (robot.gvh().id.boot() == 1 && outcomes.size() < 3) {
                LedgerTask<String> task = robot.ledger.tasks().get(ONE);
                if (!task.isOpen()) {
                  break;
                }
                auction.bid(task, cost);
                robot.waitFor(auction::isOver);
                outcomes.add(auction.isWon());
                if (auction.isWon() && !robot.is("bot2", 1)) {
                  outcomes.add(robot.told(robot.ledger.claim(ONE)));
                }
                if (auction.isWon()) {
                  robot.pause(5_000); // bot2 crashes before it claims
                }
                robot.pause(100);
              }
              return outcomes;
            },
            "crash(bot2,at=5800ms,restart=30s)");
    assertThat(result.results().toString())
        .contains("bot0=[false, false, false]")
        .containsPattern("bot1=\\[(false, )+true, DONE]");
  }
}
