package org.starl.sim.explore;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
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
    return run(SENDERS, schedule, order);
  }

  private static RunOutcome run(int senders, List<Fault> schedule, Order order) {
    try {
      return RunOutcome.of(
          Simulation.builder()
              .robots(senders + 1, Reversed::new)
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

  private static Explorer exhaustive(long mostDelayMs, int losses, int mostSchedules) {
    return explorer(Strategy.EXHAUSTIVE, SENDERS, mostDelayMs, losses, mostSchedules);
  }

  private static Explorer explorer(
      Strategy strategy, int depth, long mostDelayMs, int losses, int mostSchedules) {
    return new Explorer(
        exploration(strategy, depth, mostDelayMs, losses, mostSchedules), ExplorerTest::run);
  }

  private static Exploration exploration(
      Strategy strategy, int depth, long mostDelayMs, int losses, int mostSchedules) {
    long mostNs = mostDelayMs * Time.NS_PER_MS;
    Bounds bounds =
        new Bounds(
            0,
            Time.NS_PER_MS,
            mostNs,
            Math.max(0, mostNs - 20 * Time.NS_PER_MS),
            losses,
            0,
            Time.NS_PER_S);
    return new Exploration(strategy, depth, 7, mostSchedules, bounds);
  }

  @Test
  void anExhaustiveSearchFindsAnOrderThatNoSeedDraws() throws InterruptedException {
    Result result = exhaustive(100, 0, 10_000).run();
    assertThat(result.found()).isNotNull();
    assertThat(result.found().outcome().verdict()).isEqualTo(Verdict.FAILED);
    assertThat(result.found().schedule()).hasSize(2);
  }

  @Test
  void anOrderThatNoDelayAllowsIsNotTried() throws InterruptedException {
    Result result = exhaustive(60, 0, 10_000).run();
    assertThat(result.found()).isNull();
    assertThat(result.isComplete()).isTrue();
    // The last number is sent 60 ms after the first, and arrives after it: 123, 213 or 132.
    assertThat(result.orders()).isEqualTo(3);
  }

  @Test
  void lossesMultiplyTheOrders() throws InterruptedException {
    Result result = exhaustive(25, 1, 10_000).run();
    // None lost, or one of three.
    assertThat(result.orders()).isEqualTo(4);
    assertThat(result.isComplete()).isTrue();
  }

  @Test
  void theSearchEndsAtItsLimit() throws InterruptedException {
    Result result = exhaustive(60, 0, 3).run();
    assertThat(result.schedules()).isEqualTo(3);
    assertThat(result.isComplete()).isFalse();
  }

  /** The schedules of part {@code number} of {@code count}, split by their first numbers. */
  private static List<Explored> part(Explorer explorer, int number, int count, int kept)
      throws InterruptedException {
    List<Explored> part = new ArrayList<>();
    Predicate<List<Long>> isOwn =
        place -> (place.isEmpty() ? 0 : place.get(0) % count) == number % count;
    explorer.run(isOwn, List.of(), explored -> !part.add(explored));
    List<Explored> again = new ArrayList<>(part.subList(0, Math.min(kept, part.size())));
    explorer.run(isOwn, List.copyOf(again), explored -> !again.add(explored));
    assertThat(again).as("resumed after %s schedules", kept).isEqualTo(part);
    return part;
  }

  @ParameterizedTest
  @CsvSource({"EXHAUSTIVE, 0, 10000", "RANDOM, 0, 40", "PCT, 2, 40"})
  void partsHaveEachScheduleOfTheWholeOnce(Strategy strategy, int losses, int most)
      throws InterruptedException {
    Explorer explorer =
        new Explorer(
            exploration(strategy, SENDERS + 1, 150, losses, most),
            (schedule, order) -> run(SENDERS + 1, schedule, order));
    List<Explored> whole = part(explorer, 0, 1, 0);
    assertThat(whole.size()).isGreaterThan(30);
    Result result = explorer.run();
    assertThat(result.schedules()).isEqualTo(whole.size());
    assertThat(result.found()).isNull();
    for (int count : List.of(2, 3, 8)) {
      List<Explored> union = new ArrayList<>();
      for (int number = 0; number < count; number++) {
        union.addAll(part(explorer, number, count, 4 * number));
      }
      union.sort(
          Comparator.comparingInt((Explored one) -> one.place().size())
              .thenComparing(one -> one.place().toString()));
      List<Explored> expected = new ArrayList<>(whole);
      expected.sort(
          Comparator.comparingInt((Explored one) -> one.place().size())
              .thenComparing(one -> one.place().toString()));
      assertThat(union).as("%s parts", count).isEqualTo(expected);
    }
  }

  @Test
  void drawnPrioritiesFindTheOrder() throws InterruptedException {
    Result result = explorer(Strategy.PCT, 1, 100, 0, 1000).run();
    assertThat(result.found()).isNotNull();
    assertThat(explorer(Strategy.PCT, 1, 100, 0, 1000).run()).isEqualTo(result);
  }

  @Test
  void theScheduleFoundFailsAgain() throws InterruptedException {
    Explorer.Found found = exhaustive(100, 0, 10_000).run().found();
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
