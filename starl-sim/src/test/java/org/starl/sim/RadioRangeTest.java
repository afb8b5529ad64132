package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.WheelCommand;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.shape.WireReader;
import org.starl.sim.net.Latency;
import org.starl.time.Time;

/** The settings radioRange and radioSight. */
final class RadioRangeTest {

  private static final Channel<Integer> CHANNEL =
      new Channel<>("test", "range", Codec.of((m, out) -> out.i32(m), WireReader::i32));
  private static final int TICKS = 12;
  private static final double SIDE_MM = 12_000;

  /** Drives about, broadcasts, and returns what it heard. */
  private static final class Talker extends LogicThread {
    private final Endpoint<Integer> endpoint;
    private final Rng rng;
    private final List<Object> heard = new ArrayList<>();
    private int tick;

    Talker(GlobalVarHolder gvh, long phaseNs) {
      super(gvh, 500, phaseNs);
      rng = gvh.plat.entropy.fork("drive");
      endpoint =
          gvh.comms.open(
              CHANNEL, (from, tick) -> heard.add(from + " " + tick + " " + gvh.plat.clock.nowNs()));
    }

    @Override
    protected boolean step() {
      gvh.plat.moat.doDrive(new WheelCommand(500 * rng.nextDouble(), rng.nextBoolean(0.5) ? 0 : 2));
      if (tick < TICKS) {
        endpoint.broadcast(tick);
      }
      tick++;
      // One step more, so that the last broadcasts arrive.
      return tick <= TICKS;
    }

    @Override
    protected List<Object> returnResults() {
      return heard;
    }
  }

  private static SimSettings.Builder settings() {
    return SimSettings.builder()
        .floorWidth(SIDE_MM)
        .floorHeight(SIDE_MM)
        .messageDelay(new Latency.Constant(10 * Time.NS_PER_MS))
        .duration(Duration.ofMinutes(1));
  }

  private static Obstacles walls(Rng rng) {
    List<Obstacle> walls = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      Point from = new Point(rng.nextDouble() * SIDE_MM, rng.nextDouble() * SIDE_MM);
      walls.add(
          Obstacle.wall(
              from, from.plus(new Point(1500 * rng.nextDouble(), 1500 * rng.nextDouble()))));
    }
    return new Obstacles(walls);
  }

  private static SimResult run(long seed, boolean inPhase, SimSettings settings, String... faults) {
    Simulation.Builder simulation =
        Simulation.builder()
            .seed(seed)
            .settings(settings)
            .obstacles(walls(new Rng(seed)))
            .robots(
                40,
                gvh ->
                    new Talker(
                        gvh,
                        inPhase
                            ? 0
                            : gvh.plat.entropy.fork("phase").nextLong(0, 499 * Time.NS_PER_MS)));
    for (String fault : faults) {
      simulation.fault(fault);
    }
    return simulation.build().run();
  }

  private static SortedMap<RobotId, List<Object>> results(SimResult result) {
    return result.results();
  }

  /** The faults judge each copy, pair by pair; the settings search once for all hearers. */
  @Property(tries = 12)
  void robotsHearWhatTheFaultsRangeAndSightLetThrough(
      @ForAll @IntRange(min = 1, max = 100_000) int seed,
      @ForAll boolean inPhase,
      @ForAll boolean sight,
      @ForAll @IntRange(min = 500, max = 15_000) int rangeMm) {
    SimSettings limited = settings().radioRange(rangeMm).radioSight(sight).build();
    String range = "range(" + rangeMm + "mm)";
    SimResult byFaults =
        sight
            ? run(seed, inPhase, settings().build(), range, "sight")
            : run(seed, inPhase, settings().build(), range);
    SimResult bySettings = run(seed, inPhase, limited);
    assertThat(results(bySettings)).isEqualTo(results(byFaults));
    // A rule that passes everything changes nothing: then each copy is an event of its own.
    SimResult copies = run(seed, inPhase, limited, "delay(0ms)");
    assertThat(results(copies)).isEqualTo(results(bySettings));
  }

  @Test
  void aBroadcastToRobotsInRangeIsOneEventWithOneDelay() {
    SimSettings limited =
        settings().radioRange(40_000).messageDelay(Latency.parse("uniform(10ms,200ms)")).build();
    SimResult all = run(3, true, limited);
    List<Object> heard = results(all).get(new RobotId("bot1"));
    List<Object> same = results(all).get(new RobotId("bot2"));
    assertThat(heard).hasSize(39 * TICKS);
    assertThat(same.stream().filter(line -> ((String) line).startsWith("bot7 ")).toList())
        .hasSize(TICKS)
        .isEqualTo(heard.stream().filter(line -> ((String) line).startsWith("bot7 ")).toList());
    SimResult copies = run(3, true, limited, "delay(0ms)");
    assertThat(results(copies)).isEqualTo(results(all));
    assertThat(copies.events() - all.events()).isEqualTo(40 * TICKS * 38);
  }

  @Test
  void lossIsDrawnForEachRobotInRange() {
    SimResult all = run(5, true, settings().radioRange(40_000).messageLoss(0.25).build());
    assertThat(all.network().sent()).isEqualTo(40 * TICKS);
    assertThat(all.network().delivered() + all.network().lost()).isEqualTo(40 * TICKS * 39);
    assertThat((double) all.network().lost())
        .isBetween(0.2 * 40 * TICKS * 39, 0.3 * 40 * TICKS * 39);
  }

  @Test
  void aMessageToARobotOutOfRangeIsDropped() {
    List<String> got = new ArrayList<>();
    Simulation.Builder simulation =
        Simulation.builder().settings(settings().radioRange(3000).build());
    for (int i = 0; i < 3; i++) {
      Pose start = new Pose(1000 + 2000 * i, 1000, 0);
      simulation.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              start,
              true,
              gvh ->
                  new LogicThread(gvh) {
                    @Override
                    public List<Object> callStarL() {
                      Endpoint<Integer> endpoint =
                          gvh.comms.open(CHANNEL, (from, m) -> got.add(from + ">" + gvh.id.name()));
                      sleep(100);
                      if (gvh.id.name().name().equals("bot0")) {
                        endpoint.send(new RobotId("bot1"), 1);
                        endpoint.send(new RobotId("bot2"), 1);
                      }
                      sleep(100);
                      return List.of();
                    }
                  }));
    }
    SimResult result = simulation.build().run();
    assertThat(got).containsExactly("bot0>bot1");
    assertThat(result.network().lost()).isEqualTo(1);
  }

  @Test
  void aLineOfSightNeedsARange() {
    assertThatThrownBy(() -> run(1, true, settings().radioSight(true).build()))
        .isInstanceOf(BadInput.class)
        .hasMessage("radioSight=true: expected a radioRange above 0, such as 3m");
  }
}
