package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.Pose;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.shape.Shapes;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.check.ErrorRate;
import org.starl.sim.check.Levels;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.Splitting;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class RedrawsTest {

  private static final long S = 1_000_000_000;
  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");
  private static final int ROUNDS = 24;
  private static final int MANY = 14;

  private static final Channel<Integer> COINS =
      new Channel<>(
          "test",
          "coins",
          new Codec<>() {
            @Override
            public void write(Integer message, WireWriter out) {
              out.i64(message);
            }

            @Override
            public Integer read(WireReader in) {
              return (int) in.i64();
            }
          });

  private static final Var<Double> X = Var.of("x", Shapes.REAL);

  /** Tosses a coin in each round, sends a message if it shows heads, and counts what arrives. */
  private static final class Tosser extends LogicThread {
    private int heard;

    Tosser(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Integer> endpoint = gvh.comms.open(COINS, (from, message) -> hear());
      GvhCell<Double> x = gvh.variable(X, 0.0);
      Rng coin = gvh.plat.entropy.fork("coin");
      for (int i = 0; i < ROUNDS; i++) {
        if (gvh.id.name().equals(BOT0) && coin.nextBoolean(0.5)) {
          endpoint.broadcast(i);
        }
        x.set(gvh.gps.hasFix() ? gvh.gps.pose().xMm() : 0);
        sleep(100);
      }
      return List.of(heard);
    }

    private void hear() {
      heard++;
      gvh.trace.action("app", "heard" + heard);
    }
  }

  /** Half of the coins show heads, and half of the messages arrive. */
  private static Simulation.Builder tossers(long seed, Redraws redraws, SimObserver observer) {
    return Simulation.builder()
        .seed(seed)
        .robot(new RobotSpec(BOT0, new Pose(0, 0, 0), true, Tosser::new))
        .robot(new RobotSpec(BOT1, new Pose(0, 2000, 0), true, Tosser::new))
        .settings(
            SimSettings.builder()
                .duration(Duration.ofSeconds(10))
                .messageLoss(0.5)
                .positionNoise(5)
                .redraws(redraws)
                .build())
        .observer(observer);
  }

  private static List<TraceEvent> events(long seed, String redraws, Predicate<TraceEvent> which) {
    List<TraceEvent> events = new ArrayList<>();
    SimObserver observer =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (which.test(event)) {
              events.add(event);
            }
          }
        };
    tossers(seed, Redraws.parse(redraws), observer).build().run();
    return events;
  }

  private static boolean isAt(TraceEvent event, long fromNs, long untilNs) {
    return event.timeNs() >= fromNs && event.timeNs() < untilNs;
  }

  @Test
  void theRunIsTheSameUntilARedrawAndAnotherOneAfterIt() {
    Predicate<TraceEvent> before = event -> isAt(event, 0, S);
    Predicate<TraceEvent> after = event -> isAt(event, S, 10 * S);
    assertThat(events(7, "1s#1", before)).isNotEmpty().isEqualTo(events(7, "", before));
    assertThat(events(7, "1s#1", after)).isEqualTo(events(7, "1s#1", after));
    List<Predicate<TraceEvent>> sources =
        List.of(
            event -> event instanceof TraceEvent.Sent,
            event -> event instanceof TraceEvent.Dropped,
            event -> event instanceof TraceEvent.Variable);
    for (Predicate<TraceEvent> source : sources) {
      assertThat(events(7, "1s#1", after.and(source)))
          .isNotEqualTo(events(7, "", after.and(source)))
          .isNotEqualTo(events(7, "1s#2", after.and(source)));
    }
  }

  private static final class FirstFix extends LogicThread {

    FirstFix(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      gvh.trace.action("app", "fix");
      sleep(2000);
      return List.of();
    }
  }

  @Test
  void aRobotsFixesKeepTheirPhaseOverARedrawAndARestart() {
    List<Long> phases = new ArrayList<>();
    Simulation.builder()
        .seed(3)
        .robot(new RobotSpec(BOT0, new Pose(0, 0, 0), true, FirstFix::new))
        .settings(
            SimSettings.builder()
                .set("faults", "crash(bot0,at=1s,restart=510ms)")
                .set("redraws", "500ms#1")
                .set("positionPeriod", "75ms")
                .build())
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof TraceEvent.Action) {
                  phases.add(event.timeNs() % 75_000_000);
                }
              }
            })
        .build()
        .run();
    assertThat(phases).hasSize(2);
    assertThat(phases.get(1)).isEqualTo(phases.get(0));
  }

  /** The probability that {@link #MANY} of the rounds' messages arrive. */
  private static double exact() {
    double sum = 0;
    double term = StrictMath.pow(0.75, ROUNDS);
    for (int k = 0; k <= ROUNDS; k++) {
      sum += k >= MANY ? term : 0;
      term *= (ROUNDS - k) / (k + 1.0) / 3;
    }
    return sum;
  }

  private static Splitting.Sample sample(long seed, Redraws redraws) {
    Levels levels = new Levels(List.of("app.heard6", "app.heard9", "app.heard12"));
    SimResult result = tossers(seed, redraws, levels).build().run();
    int heard = (Integer) result.results().get(BOT1).get(0);
    RunOutcome outcome = RunOutcome.of(result);
    if (heard >= MANY) {
      Violation violation = new Violation("few", result.endNs(), List.of(), "heard " + heard);
      outcome = RunOutcome.violated(violation, outcome.figures());
    }
    return new Splitting.Sample(outcome, levels.atNs());
  }

  @Test
  @Tag("long")
  void splittingEstimatesTheProbabilityThatDelaysLossesAndProgramsGiveARun() {
    assertThat(exact()).isBetween(1e-4, 1e-3);
    Splitting splitting = new Splitting(3, 4);
    double sum = 0;
    double squares = 0;
    int seeds = 300;
    for (int seed = 1; seed <= seeds; seed++) {
      double bad = splitting.run(seed, RedrawsTest::sample).bad();
      sum += bad;
      squares += bad * bad;
    }
    ErrorRate.Estimate estimate = ErrorRate.between(sum, squares, seeds, 0.95);
    assertThat(exact()).as("%s", estimate).isBetween(estimate.low(), estimate.high());
    assertThat(estimate.high()).as("as rare as it is").isLessThan(5 * exact());
    assertThat(estimate.low()).isGreaterThan(exact() / 5);
  }

  @ParameterizedTest
  @CsvSource({
    "5s, 'expected a time and a whole number, such as 12.3s#17'",
    "5s#x, expected a whole number",
    "5#1, expected a",
    "5s#-1, expected a whole number"
  })
  void aTextThatNamesNoTimeIsRefused(String text, String message) {
    assertThatThrownBy(() -> SimSettings.builder().set("redraws", text))
        .hasMessageStartingWith("redraws=")
        .hasMessageContaining(message);
  }

  @Test
  void theTextOfRedrawsReadsBack() {
    Redraws two = Redraws.parse(" 12.3s#17 ; 12300000001ns # 4");
    assertThat(two.all())
        .containsExactly(new Redraws.One(12_300_000_000L, 17), new Redraws.One(12_300_000_001L, 4));
    assertThat(Redraws.parse(two.toString())).isEqualTo(two);
  }
}
