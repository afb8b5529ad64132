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
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.kernel.CarrierKind;
import org.starl.trace.TraceEvent;

class SimulationTest {

  private static final Channel<Long> GREETINGS =
      new Channel<>(
          "test",
          "greetings",
          new Codec<>() {
            @Override
            public void write(Long message, WireWriter out) {
              out.i64(message);
            }

            @Override
            public Long read(WireReader in) {
              return in.i64();
            }
          });

  /** Drives a metre, broadcasts greetings on the way, and returns the result of its motion. */
  private static final class Greeter extends LogicThread {
    private int heard;

    Greeter(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Long> endpoint = gvh.comms.open(GREETINGS, (from, message) -> heard++);
      await(gvh.gps::hasFix);
      Pose start = gvh.gps.pose();
      gvh.plat.moat.doMove(new ItemPosition("goal", start.xMm() + 1000, start.yMm()));
      while (gvh.plat.moat.inMotion()) {
        endpoint.broadcast(gvh.plat.entropy.fork("word").nextLong());
        sleep(100);
      }
      return List.of(gvh.plat.moat.motionflag().get(), heard);
    }
  }

  private static Simulation.Builder greeters(long seed) {
    Simulation.Builder builder = Simulation.builder().name("greeters").seed(seed);
    for (int i = 0; i < 4; i++) {
      builder.robot(
          new RobotSpec(new RobotId("bot" + i), new Pose(0, 1000 * i, 1), true, Greeter::new));
    }
    return builder.settings(
        SimSettings.builder()
            .set("messageLoss", "0.2")
            .set("positionNoise", "5mm")
            .set("duration", "60s")
            .build());
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
  void everyRobotDrivesOneMetreAndReceivesMessages() {
    SimResult result = greeters(1).build().run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.results()).hasSize(4);
    result
        .results()
        .forEach((robot, ended) -> {
          assertThat(ended.get(0)).isEqualTo(MotionFlag.DONE);
          assertThat((Integer) ended.get(1)).isPositive();
        });
  }

  @Test
  void equalSeedsGiveEqualTracesOnBothCarriers() {
    String first = trace(greeters(7).carriers(CarrierKind.PLATFORM));
    assertThat(trace(greeters(7).carriers(CarrierKind.PLATFORM))).isEqualTo(first);
    assertThat(trace(greeters(7).carriers(CarrierKind.best()))).isEqualTo(first);
    assertThat(trace(greeters(8))).isNotEqualTo(first);
  }

  @Test
  void anAdditionalRobotDoesNotChangeTheRandomNumbersOfOthers() {
    Simulation.Builder more = greeters(7);
    more.robot(new RobotSpec(new RobotId("far"), new Pose(90_000, 0, 0), true, Silent::new));
    assertThat(fixesOf("bot2", trace(more))).isEqualTo(fixesOf("bot2", trace(greeters(7))));
  }

  private static List<String> fixesOf(String robot, String trace) {
    List<String> lines = new ArrayList<>();
    for (String line : trace.split("\n")) {
      if (line.contains("\"" + robot + "\"") && line.contains("motionflag")) {
        lines.add(line);
      }
    }
    assertThat(lines).isNotEmpty();
    return lines;
  }

  private static final class Silent extends LogicThread {
    Silent(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      return List.of();
    }
  }

  @Test
  void anErrorOfAnAppEndsTheRunAndNamesRobotTimeAndSeed() {
    Simulation simulation =
        Simulation.builder()
            .name("broken")
            .seed(99)
            .robot(new RobotSpec(new RobotId("bot3"), new Pose(0, 0, 0), true, Broken::new))
            .build();
    assertThatThrownBy(simulation::run)
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContaining("seed 99")
        .hasMessageContaining("bot3")
        .hasMessageContaining("1.500")
        .hasMessageContaining("on purpose");
  }

  private static final class Broken extends LogicThread {
    Broken(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      sleep(1500);
      throw new IllegalStateException("on purpose");
    }
  }

  @Test
  void robotsAppearJoinAndLeave() {
    List<String> told = new ArrayList<>();
    RobotSpec waiting = new RobotSpec(new RobotId("bot0"), new Pose(0, 0, 0), false, Greeter::new);
    RobotSpec late = new RobotSpec(new RobotId("late"), new Pose(0, 900, 0), true, Greeter::new);
    SimResult result =
        Simulation.builder()
            .robot(waiting)
            .settings(SimSettings.builder().duration(Duration.ofSeconds(20)).build())
            .observer(
                new SimObserver() {
                  @Override
                  public void observed(TraceEvent event) {
                    if (event instanceof TraceEvent.Joined || event instanceof TraceEvent.Left) {
                      told.add(
                          event.getClass().getSimpleName()
                              + " "
                              + event.robot()
                              + " "
                              + event.timeNs() / 1_000_000);
                    }
                  }
                })
            .director(control -> {
              control.at(1_000_000_000, () -> control.putOnFloor(waiting.id()));
              control.at(2_000_000_000, () -> control.join(late));
              control.at(3_000_000_000L, () -> control.leave(late.id()));
            })
            .build()
            .run();
    assertThat(told).containsExactly("Joined bot0 1000", "Joined late 2000", "Left late 3000");
    assertThat(result.isFinished()).isTrue();
    assertThat(result.results()).containsOnlyKeys(waiting.id());
  }

  @Test
  void aRobotThatLeavesAndRejoinsIsANewIncarnation() {
    List<Integer> boots = new ArrayList<>();
    RobotSpec robot =
        new RobotSpec(
            new RobotId("bot0"),
            new Pose(0, 0, 0),
            true,
            gvh -> {
              boots.add(gvh.id.boot());
              return new Greeter(gvh);
            });
    SimResult result =
        Simulation.builder()
            .robot(robot)
            .robot(new RobotSpec(new RobotId("bot1"), new Pose(0, 900, 0), true, Greeter::new))
            .settings(SimSettings.builder().duration(Duration.ofSeconds(20)).build())
            .director(control -> {
              control.at(1_000_000_000, () -> control.leave(robot.id()));
              control.at(1_000_000_001, () -> control.join(robot));
            })
            .build()
            .run();
    assertThat(boots).containsExactly(1, 2);
    assertThat(result.isFinished()).isTrue();
  }

  @Test
  void anErrorOfADirectorNamesTheSeed() {
    Simulation simulation =
        Simulation.builder()
            .name("directed")
            .seed(5)
            .robot(new RobotSpec(new RobotId("bot0"), new Pose(0, 0, 0), true, Greeter::new))
            .director(control ->
                control.at(
                    100,
                    () -> {
                      throw new IllegalStateException("director");
                    }))
            .build();
    assertThatThrownBy(simulation::run)
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContaining("seed 5")
        .hasMessageContaining("100 ns")
        .hasMessageContaining("director");
  }

  @Test
  void theTimeLimitEndsARunAndNamesUnfinishedRobots() {
    SimResult result =
        greeters(1)
            .settings(SimSettings.builder().duration(Duration.ofSeconds(1)).build())
            .build()
            .run();
    assertThat(result.isFinished()).isFalse();
    assertThat(result.unfinished()).hasSize(4);
    assertThat(result.endNs()).isEqualTo(1_000_000_000);
  }
}
