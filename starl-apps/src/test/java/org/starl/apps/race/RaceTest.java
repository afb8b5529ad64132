package org.starl.apps.race;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.race.logic.Claim;
import org.starl.apps.race.logic.RaceApp;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

class RaceTest {

  private static final RaceDemo DEMO = new RaceDemo();

  private static Plan plan(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SortedMap<String, String> all = DEMO.defaults();
    all.putAll(parameters);
    Request request = new Request(seed, OptionalInt.of(robots), all);
    SimSettings.Builder builder = DEMO.defaultSettings(request).set("duration", "1200s");
    settings.forEach(builder::set);
    Plan plan = DEMO.plan(request, builder.build());
    plan.simulation().name("race").seed(seed);
    return plan;
  }

  /** Runs a race; all specifications must hold and all robots that are up must end. */
  private static SimResult run(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    Plan plan = plan(seed, robots, parameters, settings);
    return checked(plan.simulation(), "seed " + seed + ", " + robots + " robots, " + settings);
  }

  private static SimResult checked(Simulation.Builder simulation, String which) {
    SimResult result = simulation.build().run();
    assertThat(result.spec().violations()).as(which).isEmpty();
    assertThat(result.unfinished()).as(which).isEmpty();
    return result;
  }

  private static List<String> winners(SimResult result, int points) {
    var all = new HashSet<List<Object>>();
    result.results().values().forEach(ended -> all.add(ended.subList(0, points)));
    assertThat(all).hasSize(1);
    return all.iterator().next().stream().map(String::valueOf).toList();
  }

  @ParameterizedTest
  @CsvSource({"four.wpt, 2", "four1.wpt, 4", "four.wpt, 16"})
  void allPointsOfTheOriginalsFilesAreWonWithAndWithoutLoss(String file, int robots) {
    Path points =
        Path.of(System.getProperty("starl.shared", "../../shared"))
            .resolve("data/starl-original/race")
            .resolve(file);
    assumeTrue(Files.exists(points), "skipped: no file " + points + " (set -Dstarl.shared)");
    for (long seed = 1; seed <= 5; seed++) {
      SimResult result =
          run(
              seed,
              robots,
              Map.of("points", points.toString()),
              Map.of("messageLoss", seed % 2 == 0 ? "0" : "0.2"));
      assertThat(winners(result, 4)).hasSize(4);
    }
  }

  @Test
  void aPointUnderABoxIsWonFromBesideIt() {
    Plan plan = plan(1, 1, Map.of("drawn", "2", "boxes", "1"), Map.of());
    Map<Integer, Integer> keptOffMm = new TreeMap<>();
    SimObserver wins =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            Claim claim = RaceFact.taken(event);
            if (claim != null) {
              keptOffMm.put(claim.point(), claim.keptOffMm());
            }
          }
        };
    checked(plan.simulation().observer(wins), "boxes=1");
    assertThat(keptOffMm.get(0)).isBetween(200, 405);
    assertThat(keptOffMm.get(1)).isZero();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 9, 30})
  void anyNumberOfRobotsFinishes(int robots) {
    SimResult result = run(robots, robots, Map.of(), Map.of("messageLoss", "0.2"));
    assertThat(winners(result, 5)).hasSize(5);
  }

  @Test
  void sixtyFourRobotsFinish() {
    SimResult result = run(1, 64, Map.of("drawn", "3"), Map.of("messageLoss", "0.2"));
    assertThat(result.results()).hasSize(64);
    assertThat(winners(result, 3)).hasSize(3);
  }

  @ParameterizedTest
  @ValueSource(strings = {"moving", "spatial"})
  void underChaosAllRobotsAgree(String envelope) {
    for (long seed = 1; seed <= 8; seed++) {
      SimResult result = run(seed, 5, Map.of("drawn", "3"), Map.of("chaos", envelope));
      assertThat(winners(result, 3)).hasSize(3);
    }
  }

  @Test
  void crashedRobotsDoNotDelayTheOthers() {
    for (long seed = 1; seed <= 5; seed++) {
      Map<String, String> faults =
          Map.of("faults", "crash(bot1,at=8s); crash(bot2,at=15s)", "messageLoss", "0.2");
      SimResult result = run(seed, 5, Map.of(), faults);
      assertThat(result.results().keySet())
          .contains(new RobotId("bot0"))
          .doesNotContain(new RobotId("bot1"));
      assertThat(winners(result, 5)).hasSize(5);
      assertThat(result.results().get(new RobotId("bot0")).get(5))
          .asString()
          .startsWith("not confirmed by ")
          .contains("bot1");
    }
  }

  /** Crashes the winner of the first point for ever, within a millisecond. */
  private static final class KillsFirstWinner implements Director, SimObserver {
    private @Nullable RobotId winner;

    @Override
    public void observed(TraceEvent event) {
      if (winner == null && event instanceof Action action && action.name().equals("arrive")) {
        winner = action.robot();
      }
    }

    @Override
    public void direct(SimControl control) {
      if (winner == null) {
        control.at(control.nowNs() + 1_000_000, () -> direct(control));
      } else {
        control.crash(winner);
      }
    }
  }

  /**
   * When each robot first knew the first point's winner after {@code fromNs}, and which arrived.
   */
  private static final class FirstPoint implements SimObserver {
    private final long fromNs;
    private final Map<RobotId, Long> knewNs = new TreeMap<>();
    private final List<RobotId> arrived = new ArrayList<>();

    FirstPoint(long fromNs) {
      this.fromNs = fromNs;
    }

    @Override
    public void observed(TraceEvent event) {
      if (event instanceof Action action
          && action.fact() instanceof RaceFact.Arrived there
          && there.point() == 0) {
        arrived.add(action.robot());
      }
      Claim claim = RaceFact.taken(event);
      if (claim != null && claim.point() == 0 && event.timeNs() >= fromNs) {
        knewNs.putIfAbsent(event.robot(), event.timeNs());
      }
    }
  }

  /** bot0 is the nearest to the first point. */
  private static Simulation.Builder fourToTwoPoints() {
    List<RacePoint> points =
        List.of(
            new RacePoint("A", new Point(1000, 1000), 75),
            new RacePoint("B", new Point(3000, 1000), 75));
    Simulation.Builder simulation =
        Simulation.builder()
            .seed(1)
            .settings(SimSettings.builder().set("duration", "600s").build());
    for (int i = 0; i < 4; i++) {
      simulation.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              Pose.of(new Point(1000 + 800 * i, 1400 + 300 * i), 0),
              true,
              gvh -> new RaceApp(gvh, "race", points)));
    }
    RaceDemo.watch(simulation, points, SimSettings.defaults());
    return simulation;
  }

  private static SimResult withDeadWinner(FirstPoint first, String fault) {
    KillsFirstWinner kills = new KillsFirstWinner();
    Simulation.Builder simulation =
        fourToTwoPoints().director(kills).observer(kills).observer(first);
    if (!fault.isEmpty()) {
      simulation.fault(fault);
    }
    return checked(simulation, "dead winner, " + fault);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "loss(1,from=bot0,to=bot2)"})
  void othersRepeatTheClaimOfAWinnerThatCrashesAtOnce(String fault) {
    FirstPoint first = new FirstPoint(0);
    SimResult result = withDeadWinner(first, fault);
    assertThat(result.results()).hasSize(3);
    assertThat(winners(result, 2).get(0)).isEqualTo("bot0");
    assertThat(first.arrived).containsExactly(new RobotId("bot0"));
    assertThat(first.knewNs).hasSize(4);
    long firstNs = Collections.min(first.knewNs.values());
    assertThat(Collections.max(first.knewNs.values()) - firstNs).isLessThan(100_000_000);
  }

  @Test
  void aRobotThatRestartsAsksAndDoesNotRaceToAPointThatIsWon() {
    long restartNs = 7_000_000_000L;
    FirstPoint first = new FirstPoint(restartNs);
    SimResult result =
        checked(fourToTwoPoints().observer(first).fault("crash(bot1,at=6s,restart=1s)"), "restart");
    assertThat(result.results()).hasSize(4);
    assertThat(winners(result, 2).get(0)).isEqualTo("bot0");
    assertThat(first.arrived).containsExactly(new RobotId("bot0"));
    assertThat(first.knewNs.getOrDefault(new RobotId("bot1"), Long.MAX_VALUE))
        .isLessThan(restartNs + 100_000_000);
  }

  @Test
  void aPointBlockedByACrashedRobotIsWonFromBesideIt() {
    SimResult result = withDeadWinner(new FirstPoint(0), "loss(1,from=bot0)");
    assertThat(result.results()).hasSize(3);
    assertThat(winners(result, 2).get(0)).isNotEqualTo("bot0");
  }

  @Test
  void robotsThatArriveBeforeHearingOfAWinnerAgreeEventually() {
    long arrivals = 0;
    for (long seed = 1; seed <= 10; seed++) {
      Map<String, String> settings =
          Map.of("idealMotion", "true", "messageDelay", "uniform(500ms,3s)");
      Plan plan = plan(seed, 6, Map.of("drawn", "4"), settings);
      assertThat(winners(checked(plan.simulation(), "seed " + seed), 4)).hasSize(4);
      arrivals += plan.story().measures().counts().getOrDefault("arrivals", 0L);
    }
    assertThat(arrivals).isGreaterThan(4 * 10);
  }

  @Test
  void aFileOfPointsIsReadAndTheErrorNamesABadOne(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("points.wpt");
    Files.writeString(file, "// two\nWAY,1,2,0,A\nWAY,3,4,0,B,10\nSENSE,5,6,0,C\n");
    assertThat(RacePoints.read(file.toString()))
        .containsExactly(
            new RacePoint("A", new Point(1, 2), 75), new RacePoint("B", new Point(3, 4), 10));
    Map<String, String> bad =
        Map.of(
            "SENSE,5,6,0,C\n", "has 0 points: expected 1 to 1000 WAY lines",
            "WAY,1,2,0,A\nWAY,1,3,0,A\n", "two points are called 'A': expected different names",
            "WAY,1,2,0,A,0\n", "point 'A': expected a radius above 0");
    for (Map.Entry<String, String> one : bad.entrySet()) {
      Files.writeString(file, one.getKey());
      assertThatThrownBy(() -> RacePoints.read(file.toString()))
          .isInstanceOf(BadInput.class)
          .hasMessage(file + ": " + one.getValue());
    }
    assertThatThrownBy(() -> plan(1, 1001, Map.of(), Map.of()))
        .hasMessage("robots: 1001: expected 1 to 1000 in a race");
    assertThatThrownBy(() -> plan(1, 4, Map.of("drawn", "none"), Map.of()))
        .hasMessageContaining("drawn: 'none': expected a whole number from 1 to 100");
  }
}
