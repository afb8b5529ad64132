package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** The primitives on simulated robots: gvh, radio, positioning, timers. */
class GeocastSimulationTest {

  private static final Codec<String> TEXT =
      new Codec<>() {
        @Override
        public void write(String message, WireWriter out) {
          out.string(message);
        }

        @Override
        public String read(WireReader in) {
          return in.string();
        }
      };

  /** Drives along its row while the first robot sends; returns the received messages. */
  private static final class Caller extends LogicThread {
    private final List<Object> heard = new ArrayList<>();

    Caller(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Geocast<String> near =
          new Geocast<>(gvh, "near", TEXT, (origin, m) -> heard.add(origin + " near " + m));
      Broadcast<String> all =
          new Broadcast<>(gvh, "all", TEXT, (origin, m) -> heard.add(origin + " all " + m));
      await(gvh.gps::hasFix);
      sleep(500);
      Pose start = gvh.gps.pose();
      gvh.plat.moat.doMove(new ItemPosition("away", start.xMm() + 1_500, start.yMm()));
      if (gvh.id.name().name().equals("bot0")) {
        call(near, all);
      } else {
        sleep(6_000);
      }
      return heard;
    }

    private void call(Geocast<String> near, Broadcast<String> all) {
      assertThat(near.Gcastflag().get()).isFalse();
      near.do_geocast("psst", near.neighbourhood(1_700), 2_000);
      assertThat(near.Gcastflag().get()).isFalse();
      await(() -> near.Gcastflag().get());
      GeocastReceipt receipt = all.BCast("hello", 3_000);
      await(() -> all.Gcastflag().get());
      heard.add(receipt.acknowledgedBy().toString());
    }
  }

  private static SimResult run(long seed, String loss, String noise) {
    Simulation.Builder builder =
        Simulation.builder()
            .seed(seed)
            .monitor(() -> new GeocastSpec(200, GeocastSettings.DEFAULT));
    for (int i = 0; i < 5; i++) {
      builder.robot(
          new RobotSpec(new RobotId("bot" + i), new Pose(0, 1_000 * i, 0), true, Caller::new));
    }
    return builder
        .settings(
            SimSettings.builder()
                .set("messageLoss", loss)
                .set("positionNoise", noise)
                .set("duration", "60s")
                .build())
        .build()
        .run();
  }

  @Test
  void aGeocastReachesTheNeighboursAndABroadcastReachesAll() {
    SimResult result = run(1, "0", "0mm");
    Map<String, List<Object>> heard = new TreeMap<>();
    result.results().forEach((robot, texts) -> heard.put(robot.name(), texts));
    assertThat(heard)
        .containsEntry("bot0", List.of("[bot1, bot2, bot3, bot4]"))
        .containsEntry("bot1", List.of("bot0 near psst", "bot0 all hello"))
        .containsEntry("bot2", List.of("bot0 all hello"))
        .containsEntry("bot4", List.of("bot0 all hello"));
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.spec().checks(GeocastSpec.EXCLUSION)).isEqualTo(5);
    assertThat(result.spec().checks(GeocastSpec.INCLUSION)).isGreaterThanOrEqualTo(4);
  }

  /** Sends more than its slow computer can handle the acknowledgements of within the interval. */
  private static final class Burst extends LogicThread {

    Burst(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Broadcast<String> all = new Broadcast<>(gvh, "all", TEXT, (origin, m) -> {});
      sleep(500);
      if (gvh.id.name().name().equals("bot0")) {
        for (int i = 0; i < 40; i++) {
          all.BCast("long", 2_000);
          all.BCast("short", 300);
        }
        await(() -> all.Gcastflag().get());
      }
      sleep(3_000);
      return List.of();
    }
  }

  @Test
  void theFlagIsTrueWithTheLastAcknowledgementThoughTheTimerOfOtherMessagesIsLate() {
    SimResult result =
        Simulation.builder()
            .settings(
                SimSettings.builder()
                    .set("faults", "compute(bot0,3ms); datagram(bot0>bot2,1,lost)") // a short one
                    .build())
            .monitor(() -> new GeocastSpec(200, GeocastSettings.DEFAULT).answering())
            .robots(3, Burst::new)
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.spec().violations()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void theContractHoldsWithLossAndNoise(long seed) {
    SimResult result = run(seed, "0.4", "30mm");
    assertThat(result.isFinished()).isTrue();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.spec().checks(GeocastSpec.DEADLINE)).isPositive();
  }

  @Test
  void aMessageThatDoesNotFitADatagramThrows() {
    Region big = new Circle(new Point(0, 0), 1);
    for (int i = 0; i < 100; i++) {
      big = org.starl.geometry.Union.of(big, new Circle(new Point(i, 0), 1));
    }
    Region area = big;
    Simulation simulation =
        Simulation.builder()
            .seed(1)
            .robots(
                1,
                gvh ->
                    new OneCall(
                        gvh,
                        geocast ->
                            assertThatThrownBy(() -> geocast.do_geocast("m", area, 100))
                                .isInstanceOf(IllegalArgumentException.class)))
            .build();
    assertThat(simulation.run().isFinished()).isTrue();
  }

  @Test
  void emptyIntervalsAndCallsAfterCloseThrow() {
    Simulation simulation =
        Simulation.builder()
            .seed(1)
            .robots(
                1,
                gvh ->
                    new OneCall(
                        gvh,
                        geocast -> {
                          assertThatThrownBy(() -> geocast.do_geocast("m", new Everywhere(), 0))
                              .hasMessageContaining("expected above 0");
                          geocast.close();
                          assertThatThrownBy(() -> geocast.do_geocast("m", new Everywhere(), 1))
                              .isInstanceOf(IllegalStateException.class);
                        }))
            .build();
    assertThat(simulation.run().isFinished()).isTrue();
  }

  @Test
  void aClosedGeocastIsRepeatedNoMore() {
    Simulation simulation = Simulation.builder().seed(1).robots(1, ClosesWhileItSends::new).build();
    assertThat(simulation.run().isFinished()).isTrue();
  }

  private static final class ClosesWhileItSends extends LogicThread {

    ClosesWhileItSends(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Geocast<String> geocast = new Geocast<>(gvh, "x", TEXT, (origin, message) -> {});
      geocast.do_geocast("m", new Everywhere(), 10_000);
      geocast.close();
      sleep(1_000);
      return List.of();
    }
  }

  private static final class OneCall extends LogicThread {
    private final java.util.function.Consumer<Geocast<String>> call;

    OneCall(GlobalVarHolder gvh, java.util.function.Consumer<Geocast<String>> call) {
      super(gvh);
      this.call = call;
    }

    @Override
    public List<Object> callStarL() {
      call.accept(new Geocast<>(gvh, "x", TEXT, (origin, message) -> {}));
      return List.of();
    }
  }
}
