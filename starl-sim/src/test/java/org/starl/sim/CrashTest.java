package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.world.Unsynced;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

class CrashTest {

  private static final long MS = 1_000_000;
  private static final long S = 1_000 * MS;
  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");

  private static final Channel<Integer> BEATS =
      new Channel<>(
          "test",
          "beats",
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

  /** Drives continuously, and broadcasts its boot number ten times a second for 5 s. */
  private static final class Beater extends LogicThread {
    private final List<Integer> heard = new ArrayList<>();

    Beater(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Integer> endpoint = gvh.comms.open(BEATS, (from, message) -> heard.add(message));
      await(gvh.gps::hasFix);
      Pose start = gvh.gps.pose();
      gvh.plat.moat.doMove(new ItemPosition("far", start.xMm() + 100_000, start.yMm()));
      try {
        for (int i = 0; i < 50; i++) {
          endpoint.broadcast(gvh.id.boot());
          sleep(100);
        }
      } finally {
        gvh.trace.action("app", "unwound");
        gvh.plat.stable.put("unwound", new byte[1], () -> {});
        endpoint.broadcast(-1);
        gvh.plat.moat.motion_stop();
      }
      return List.copyOf(heard);
    }
  }

  static Stream<CarrierKind> carriers() {
    return Stream.of(CarrierKind.PLATFORM, CarrierKind.best()).distinct();
  }

  private final List<TraceEvent> events = new ArrayList<>();

  private Simulation.Builder beaters(Director director) {
    return Simulation.builder()
        .seed(3)
        .robot(new RobotSpec(BOT0, new Pose(0, 0, 0), true, Beater::new))
        .robot(new RobotSpec(BOT1, new Pose(0, 2000, 0), true, Beater::new))
        .settings(
            SimSettings.builder()
                .set(Setting.DURATION, Duration.ofSeconds(60))
                .set("messageDelay", "50ms")
                .build())
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                events.add(event);
              }
            })
        .director(director);
  }

  private <T extends TraceEvent> List<T> of(Class<T> kind, RobotId robot, long fromNs) {
    return events.stream()
        .filter(kind::isInstance)
        .filter(event -> event.robot().equals(robot) && event.timeNs() >= fromNs)
        .map(kind::cast)
        .toList();
  }

  @ParameterizedTest
  @MethodSource("carriers")
  void aCrashedRobotRunsNoCodeAndStops(CarrierKind carriers) {
    Pose[] atCrash = new Pose[1];
    SimResult result =
        beaters(
                control -> {
                  control.at(
                      2 * S,
                      () -> {
                        control.crash(BOT0);
                        atCrash[0] = control.truePose(BOT0);
                        assertThat(control.isUp(BOT0)).isFalse();
                        assertThat(control.robots()).containsExactly(BOT0, BOT1);
                      });
                  control.at(4 * S, () -> assertThat(control.truePose(BOT0)).isEqualTo(atCrash[0]));
                })
            .carriers(carriers)
            .build()
            .run();
    assertThat(of(Fault.class, BOT0, 0)).containsExactly(new Fault(2 * S, BOT0, "crash", ""));
    assertThat(of(TraceEvent.Moved.class, BOT0, 2 * S))
        .singleElement()
        .satisfies(moved -> assertThat(moved.linearMmPerS()).isZero());
    assertThat(of(TraceEvent.Sent.class, BOT0, 2 * S)).isEmpty();
    assertThat(of(TraceEvent.Delivered.class, BOT0, 2 * S)).isEmpty();
    assertThat(of(TraceEvent.Action.class, BOT0, 2 * S)).as("of finally blocks").isEmpty();
    assertThat(atCrash[0].xMm()).isGreaterThan(100);
    assertThat(result.isFinished()).as("a robot that crashed for good owes no end").isTrue();
    assertThat(result.results()).containsOnlyKeys(BOT1);
  }

  @Test
  void datagramsOfACrashedRobotStillArrive() {
    beaters(control -> control.at(2 * S, () -> control.crash(BOT0))).build().run();
    long lastSentNs =
        of(TraceEvent.Sent.class, BOT0, 0).stream()
            .mapToLong(TraceEvent::timeNs)
            .max()
            .orElseThrow();
    assertThat(lastSentNs).isGreaterThan(2 * S - 50 * MS);
    assertThat(of(TraceEvent.Delivered.class, BOT1, 2 * S))
        .extracting(TraceEvent::timeNs)
        .containsExactly(lastSentNs + 50 * MS);
  }

  @ParameterizedTest
  @MethodSource("carriers")
  void aRestartIsANewIncarnationOnTheSameBodyAndTheRunWaitsForIt(CarrierKind carriers) {
    SimResult result =
        beaters(control -> control.at(2 * S, () -> control.crash(BOT0, 20 * S, Unsynced.LOST)))
            .carriers(carriers)
            .build()
            .run();
    assertThat(of(Fault.class, BOT0, 0))
        .containsExactly(
            new Fault(2 * S, BOT0, "crash", ""), new Fault(22 * S, BOT0, "restart", "lost"));
    assertThat(result.isFinished()).isTrue();
    assertThat(result.endNs()).isGreaterThan(26 * S);
    assertThat(result.results()).containsOnlyKeys(BOT0, BOT1);
    assertThat(of(TraceEvent.Joined.class, BOT0, 0)).hasSize(1);
    List<TraceEvent.Moved> moves = of(TraceEvent.Moved.class, BOT0, 2 * S);
    assertThat(moves.get(1).timeNs()).isGreaterThanOrEqualTo(22 * S);
    assertThat(moves.get(1).pose().xMm()).isEqualTo(moves.get(0).pose().xMm());
    assertThat(of(TraceEvent.Sent.class, BOT0, 22 * S)).isNotEmpty();
  }

  @Test
  void theOthersHearTheNewIncarnation() {
    SimResult result =
        beaters(control -> control.at(2 * S, () -> control.crash(BOT0, 500 * MS, Unsynced.LOST)))
            .build()
            .run();
    assertThat(result.results().get(BOT1)).contains(1, 2).doesNotContain(-1);
  }

  @Test
  void anAppThatHadEndedRunsAgainAfterARestart() {
    SimResult result =
        beaters(
                control -> {
                  control.at(4 * S, () -> control.crash(BOT1, 20 * S, Unsynced.LOST));
                  control.at(10 * S, () -> assertThat(control.isFinished(BOT0)).isTrue());
                  control.at(10 * S, () -> control.crash(BOT0, 5 * S, Unsynced.LOST));
                })
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(of(TraceEvent.Sent.class, BOT0, 15 * S)).hasSize(51);
    assertThat(of(TraceEvent.Sent.class, BOT1, 15 * S)).hasSize(51);
  }

  @Test
  void invalidCrashesAndRestartsAreRefused() {
    assertThatThrownBy(beaters(control -> control.restart(BOT0, Unsynced.LOST)).build()::run)
        .hasMessageContaining("bot0 is up");
    assertThatThrownBy(
            beaters(
                        control -> {
                          control.crash(BOT0);
                          control.crash(BOT0);
                        })
                    .build()
                ::run)
        .hasMessageContaining("bot0 has already crashed");
  }

  @Test
  void aCrashedRobotCanLeave() {
    SimResult result =
        beaters(
                control -> {
                  control.at(2 * S, () -> control.crash(BOT0, S, Unsynced.LOST));
                  control.at(2 * S + 1, () -> control.leave(BOT0));
                })
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(of(Fault.class, BOT0, 0)).hasSize(1);
  }

  /** Writes two values, which take 100 ms to be safe, and reads what it finds at its start. */
  private static final class Writer extends LogicThread {
    Writer(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      boolean first = gvh.plat.stable.get("first") != null;
      boolean second = gvh.plat.stable.get("second") != null;
      boolean unwound = gvh.plat.stable.get("unwound") != null;
      gvh.plat.stable.put("first", new byte[1], () -> {});
      sleep(50);
      gvh.plat.stable.put("second", new byte[1], () -> {});
      try {
        sleep(500);
      } finally {
        gvh.plat.stable.put("unwound", new byte[1], () -> {});
      }
      return List.of(gvh.id.boot(), first, second, unwound);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "170, LOST, false, false",
    "170, KEPT, true, true",
    "220, LOST, true, false",
    "300, LOST, true, true"
  })
  void unflushedWritesMayBeLostOrKept(
      long crashMs, Unsynced unsynced, boolean first, boolean second) {
    SimResult result = writer(1, crashMs, unsynced).build().run();
    assertThat(result.results().get(BOT0)).containsExactly(2, first, second, false);
  }

  @Test
  void theEarliestUnflushedWritesSurvive() {
    List<String> seen = new ArrayList<>();
    for (long seed = 1; seed <= 20; seed++) {
      List<Object> found = writer(seed, 170, Unsynced.SOME).build().run().results().get(BOT0);
      seen.add(found.get(1) + " " + found.get(2));
    }
    assertThat(seen)
        .contains("false false", "true false", "true true")
        .doesNotContain("false true");
  }

  private static Simulation.Builder writer(long seed, long crashMs, Unsynced unsynced) {
    return Simulation.builder()
        .seed(seed)
        .robot(new RobotSpec(BOT0, new Pose(0, 0, 0), true, Writer::new))
        .settings(SimSettings.builder().set("stableDelay", "100ms").build())
        .director(
            control -> control.at(crashMs * MS, () -> control.crash(BOT0, 10 * MS, unsynced)));
  }

  @Test
  void equalSeedsGiveEqualTracesOnBothCarriers() {
    Director director =
        control -> {
          control.at(1_234 * MS, () -> control.crash(BOT0, 700 * MS, Unsynced.SOME));
          control.at(2 * S, () -> control.crash(BOT1, 700 * MS, Unsynced.SOME));
        };
    String first = trace(beaters(director).carriers(CarrierKind.PLATFORM));
    assertThat(trace(beaters(director).carriers(CarrierKind.PLATFORM))).isEqualTo(first);
    assertThat(trace(beaters(director).carriers(CarrierKind.best()))).isEqualTo(first);
  }

  private static String trace(Simulation.Builder builder) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(bytes)) {
      builder.observer(recorder).build().run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void noRobotIsCalledWorld() {
    RobotSpec world = new RobotSpec(Fault.WORLD, new Pose(0, 0, 0), true, Writer::new);
    assertThatThrownBy(() -> Simulation.builder().robot(world).build().run())
        .hasMessageContaining("world");
  }
}
