package org.starl.sim.explore;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.RobotId;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.explore.Explorer.Result;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultPlan;
import org.starl.time.Time;

class ExplorerTest {

  private static final Channel<Long> NUMBERS =
      new Channel<>(
          "test",
          "numbers",
          new Codec<>() {
            @Override
            public void write(Long number, WireWriter out) {
              out.i64(number);
            }

            @Override
            public Long read(WireReader in) {
              return in.i64();
            }
          });

  private static final int SENDERS = 3;
  private static final long SPACING_MS = 30;

  /**
   * bot1, bot2 and bot3 send one number each to bot0, 30 ms after one another. bot0 fails if it
   * hears the last number first and the first number last.
   */
  private static final class Reversed extends LogicThread {
    private final List<Long> heard = new ArrayList<>();

    Reversed(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Long> endpoint = gvh.comms.open(NUMBERS, (from, number) -> heard.add(number));
      long me = Long.parseLong(gvh.id.name().name().substring(3));
      if (me == 0) {
        sleep(1000);
        if (heard.equals(List.of(3L, 2L, 1L))) {
          throw new IllegalStateException("reversed");
        }
      } else {
        sleep(100 + me * SPACING_MS);
        endpoint.send(new RobotId("bot0"), me);
      }
      return List.of();
    }
  }

  private static RunOutcome run(List<Fault> schedule, Order order) {
    try {
      return RunOutcome.of(
          Simulation.builder()
              .robots(SENDERS + 1, Reversed::new)
              .seed(1)
              .settings(SimSettings.builder().set("positionPeriod", "10s").build())
              .faults(new FaultPlan(schedule))
              .observer(order)
              .build()
              .run());
    } catch (RuntimeException e) {
      return RunOutcome.failed(e);
    }
  }

  private static Explorer explorer(long mostDelayMs, int losses, int crashes, int mostSchedules) {
    long mostNs = mostDelayMs * Time.NS_PER_MS;
    Bounds bounds =
        new Bounds(
            0,
            Time.NS_PER_MS,
            mostNs,
            Math.max(0, mostNs - 20 * Time.NS_PER_MS),
            losses,
            crashes,
            Time.NS_PER_S);
    return new Explorer(bounds, ExplorerTest::run, mostSchedules, (finished, planned) -> {});
  }

  @Test
  void anExhaustiveSearchFindsAnOrderThatNoSeedDraws() throws InterruptedException {
    Result result = explorer(100, 0, 0, 10_000).exhaust(SENDERS);
    assertThat(result.found()).isNotNull();
    assertThat(result.found().outcome().verdict()).isEqualTo(Verdict.FAILED);
    assertThat(result.found().schedule()).hasSize(2);
  }

  @Test
  void anOrderThatNoDelayAllowsIsNotTried() throws InterruptedException {
    Result result = explorer(60, 0, 0, 10_000).exhaust(SENDERS);
    assertThat(result.found()).isNull();
    assertThat(result.isComplete()).isTrue();
    // The last number is sent 60 ms after the first, and arrives after it: 123, 213 or 132.
    assertThat(result.orders()).isEqualTo(3);
  }

  @Test
  void lossesMultiplyTheOrders() throws InterruptedException {
    Result result = explorer(25, 1, 0, 10_000).exhaust(SENDERS);
    // None lost, or one of three.
    assertThat(result.orders()).isEqualTo(4);
    assertThat(result.isComplete()).isTrue();
  }

  @Test
  void theSearchEndsAtItsLimit() throws InterruptedException {
    Result result = explorer(60, 0, 0, 3).exhaust(SENDERS);
    assertThat(result.schedules()).isEqualTo(3);
    assertThat(result.isComplete()).isFalse();
  }

  @Test
  void drawnPrioritiesFindTheOrder() throws InterruptedException {
    Result result = explorer(100, 0, 0, 1000).draw(Strategy.PCT, 1, 7);
    assertThat(result.found()).isNotNull();
    assertThat(explorer(100, 0, 0, 1000).draw(Strategy.PCT, 1, 7)).isEqualTo(result);
  }

  @Test
  void theScheduleFoundFailsAgain() throws InterruptedException {
    Explorer.Found found = explorer(100, 0, 0, 10_000).exhaust(SENDERS).found();
    assertThat(found).isNotNull();
    FaultPlan read = FaultPlan.parse(new FaultPlan(found.schedule()).toString());
    Bounds bounds = new Bounds(0, 0, 0, 0, 0, 0, 1);
    assertThat(run(read.faults(), new Order(bounds, 1))).isEqualTo(found.outcome());
  }

  @Test
  void aRunThatIsOnlyObservedIsAsBefore() {
    Order order = new Order(new Bounds(0, 0, 0, 0, 0, 0, 1), 100);
    assertThat(run(List.of(), order).isGood()).isTrue();
    assertThat(order.copies()).hasSize(SENDERS);
    assertThat(order.copies())
        .allSatisfy(copy -> {
          long delayNs = copy.arrivesAtNs() - copy.sentAtNs();
          assertThat(delayNs).isBetween(10 * Time.NS_PER_MS, 20 * Time.NS_PER_MS);
        });
  }
}
