package org.starl.apps.fleet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.FleetApp;
import org.starl.apps.fleet.logic.FleetFact;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.apps.fleet.logic.Roads;
import org.starl.apps.fleet.robot.FleetFactory;
import org.starl.apps.fleet.spec.FleetSpec;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;
import org.starl.time.Time;

class FleetTest {

  private static final FleetDemo DEMO = new FleetDemo();

  @Test
  void chaosDrawsARangeWithWhichRobotsHaveToCharge() {
    SortedSet<Double> rangesMm = new TreeSet<>();
    for (int robots = 2; robots <= 12; robots++) {
      Roads roads = FleetFactory.roads(FleetFactory.grid(robots), 165, robots);
      for (long seed = 1; seed <= 10; seed++) {
        Request request = new Request(seed, OptionalInt.of(robots), DEMO.defaults(), Set.of());
        rangesMm.add(FleetFactory.rangeMm(DEMO.varied(request), roads));
      }
    }
    assertThat(rangesMm).containsExactly(160_000.0, 500_000.0);
  }

  private static final double BODY_MM = 165;

  private static void fill(Simulation.Builder simulation, long seed, int robots) {
    fill(simulation, seed, robots, 6, 600);
  }

  private static void fill(
      Simulation.Builder simulation, long seed, int robots, int tasks, int anHour) {
    SortedMap<String, String> parameters = DEMO.defaults();
    parameters.put("deliveries", Integer.toString(tasks));
    parameters.put("rate", Integer.toString(anHour));
    Request request = new Request(seed, OptionalInt.of(robots), parameters);
    SimSettings settings = simulation.settings();
    NavGraph graph = FleetFactory.grid(robots);
    Roads roads = new Roads(graph, settings.robotRadiusMm(), robots);
    List<Delivery> deliveries = FleetFactory.drawn(request, graph);
    RobotProgram program = FleetFactory.program(roads, deliveries, 500_000, Set.of());
    FleetDemo.fill(simulation, robots, roads, deliveries, program, 7_200 * Time.NS_PER_S);
  }

  @StarlTest(seeds = 2, atMost = "7200s")
  void everyDeliveryArrivesOnce(Simulation.Builder simulation, long seed, RunChecks checks) {
    fill(simulation, seed, 3);
    checks.check(result -> assertThat(result.results()).hasSize(3));
  }

  @Tag("long")
  @StarlTest(seeds = 10, chaos = Envelope.NETWORK, atMost = "7200s")
  void everyDeliveryArrivesOnceUnderLoss(
      Simulation.Builder simulation, long seed, RunChecks checks) {
    fill(simulation, seed, 6);
    checks.check(result -> assertThat(result.results()).hasSize(6));
  }

  @Tag("long")
  @StarlTest(seeds = 10, chaos = Envelope.MOVING, atMost = "7200s")
  void everyDeliveryArrivesOnceAfterCrashes(
      Simulation.Builder simulation, long seed, RunChecks checks) {
    fill(simulation, seed, 6);
    checks.check(result -> assertThat(result.results()).hasSize(6));
  }

  /**
   * Each robot crashes three times while all drive, and is down for less or more time than others wait for
   * it. In this run robots waited in a circle: their ways home led through each other's sections.
   */
  @Test
  void noRobotWaitsForEverAfterManyCrashes() {
    long seed = 15;
    int robots = 6;
    Rng rng = new Rng(seed).fork("storm");
    List<String> faults = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      int at = 20 + rng.nextInt(60);
      for (int crash = 0; crash < 3; crash++) {
        int down = rng.nextBoolean(0.5) ? 1 + rng.nextInt(20) : 40 + rng.nextInt(60);
        faults.add("crash(bot" + i + ",at=" + at + "s,restart=" + down + "s)");
        at += down + 20 + rng.nextInt(100);
      }
    }
    Simulation.Builder simulation =
        Simulation.builder()
            .seed(seed)
            .settings(
                SimSettings.builder()
                    .set(Setting.FAULTS.key(), String.join(";", faults))
                    .set(Setting.DURATION.key(), "1500s")
                    .build());
    fill(simulation, seed, robots, 12, 3_000);
    SimResult result = simulation.build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.results()).hasSize(robots);
  }

  /** How many of ten deliveries are put down after a robot has crashed on its way. */
  private static long completedAfter(String fault, String broken) {
    SortedMap<String, String> parameters = DEMO.defaults();
    parameters.put("deliveries", "10");
    parameters.put("broken", broken);
    Request request = new Request(12, OptionalInt.of(5), parameters);
    SimSettings settings =
        DEMO.defaultSettings(request)
            .set(Setting.FAULTS.key(), fault)
            .set(Setting.DURATION.key(), "1500s")
            .build();
    Plan plan = DEMO.plan(request, settings);
    SimResult result = plan.simulation().name("fleet").seed(12).build().run();
    assertThat(result.spec().violations("fleet.held")).isZero();
    return plan.story().measures().completed();
  }

  /** Two without ways around, and with robots that wait for its stations. */
  @Test
  void robotsDriveAroundOneThatIsLost() {
    assertThat(completedAfter("crash(bot2,at=69361ms)", "")).isGreaterThanOrEqualTo(7);
  }

  @ParameterizedTest
  @ValueSource(strings = {"bot5", "bot1+", "bot1+bot1+x", "bot1,bot2"})
  void brokenRobotsAreOfTheRun(String broken) {
    assertThatThrownBy(() -> completedAfter("", broken))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("broken: ")
        .hasMessageEndingWith("expected robots of this run, such as bot1+bot2");
  }

  @Test
  void aBrokenRobotGivesBackWhatItsBodyIsNotIn() {
    assertThat(completedAfter("crash(bot2,at=69361ms,restart=100s)", "bot2"))
        .isGreaterThan(completedAfter("crash(bot2,at=69361ms)", ""));
  }

  private static NavGraph corridor(String group) {
    return corridor(group, 1_300);
  }

  /** Two homes at the ends of a corridor for one robot, of this group, and four stations beside it. */
  private static NavGraph corridor(String group, double laneMm) {
    List<Vertex> vertices = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      boolean isHome = i == 0 || i == 4;
      vertices.add(new Vertex("v" + i, new Point(laneMm * i, 0), false, false, isHome));
    }
    for (int i = 0; i < 4; i++) {
      Point at = new Point(i < 2 ? laneMm : 3 * laneMm, i % 2 == 0 ? laneMm : -laneMm);
      vertices.add(new Vertex("s" + i, at, false, true, false));
    }
    List<Lane> lanes = new ArrayList<>();
    for (int[] pair :
        new int[][] {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {1, 5}, {1, 6}, {3, 7}, {3, 8}}) {
      String its = (pair[0] == 1 && pair[1] == 2) || pair[0] == 2 ? group : "";
      lanes.add(new Lane(pair[0], pair[1], its));
      lanes.add(new Lane(pair[1], pair[0], its));
    }
    return new NavGraph(vertices, lanes);
  }

  private static final List<Delivery> BOTH_WAYS =
      List.of(new Delivery(0, 5, 7), new Delivery(100, 8, 6));

  /** A robot with bodies of no size in mind: it needs no section, and asks for none. */
  private static LogicThread unasked(GlobalVarHolder gvh) {
    return new FleetApp(gvh, new Roads(corridor(""), -50, 2), BOTH_WAYS, 0, false);
  }

  /** A robot that knows no groups. */
  private static LogicThread ungrouped(GlobalVarHolder gvh) {
    return new FleetApp(gvh, new Roads(corridor(""), BODY_MM, 2), BOTH_WAYS, 0, false);
  }

  /** A robot whose battery is suddenly full, or that leaves its charger too early. */
  private static LogicThread charging(GlobalVarHolder gvh, boolean leaves) {
    return new LogicThread(gvh) {
      @Override
      public List<Object> callStarL() {
        GvhCell<Integer> charge = gvh.variable(FleetFact.CHARGE, 50);
        GvhCell<FleetFact.Work> work = gvh.variable(FleetFact.WORK, FleetFact.Work.PARKS);
        if (leaves) {
          work.set(FleetFact.Work.CHARGES);
          charge.set(80);
          work.set(FleetFact.Work.PARKS);
        } else {
          charge.set(100);
        }
        return List.of();
      }
    };
  }

  /** A robot that says what is not so. */
  private static LogicThread liar(GlobalVarHolder gvh) {
    return new LogicThread(gvh) {
      @Override
      public List<Object> callStarL() {
        gvh.variable(FleetFact.ABOARD, 0L).set(1L);
        gvh.variable(FleetFact.DELIVERED, 0L).set(1L);
        gvh.variable(FleetFact.CHARGE, 1).set(0);
        gvh.variable(FleetFact.LANE, List.of()).set(List.of(1, 2));
        await(gvh.gps::hasFix);
        gvh.plat.moat.doMove(new ItemPosition("away", 2_600, -2_000));
        sleep(10_000);
        return List.of();
      }
    };
  }

  private static SimResult run(Function<GlobalVarHolder, LogicThread> app) {
    return run(corridor("tunnel"), app);
  }

  private static SimResult run(NavGraph graph, Function<GlobalVarHolder, LogicThread> app) {
    Simulation.Builder simulation =
        Simulation.builder()
            .seed(1)
            .settings(SimSettings.builder().set("duration", "1000s").build())
            .monitor(
                () -> new FleetSpec(new Roads(graph, BODY_MM, 2), BOTH_WAYS, 60 * Time.NS_PER_S));
    for (int i = 0; i < 2; i++) {
      Pose start = new Pose(graph.vertices().get(4 * i).at().xMm(), 0, 0);
      simulation.robot(new RobotSpec(new RobotId("bot" + i), start, true, app));
    }
    return simulation.build().run();
  }

  @ParameterizedTest
  @CsvSource({
    "unasked, fleet.apart",
    "unasked, fleet.one_way",
    "unasked, fleet.group",
    "unasked, fleet.held",
    "ungrouped, fleet.held",
    "unasked, fleet.in_time",
    "liar, fleet.on_lane",
    "liar, fleet.begun",
    "liar, fleet.once",
    "liar, fleet.charged",
    "filled, fleet.charged",
    "hasty, fleet.charged",
    "liar, fleet.none_lost",
  })
  void aPlantedBugViolatesItsLemma(String bug, String lemma) {
    SimResult result =
        run(
            switch (bug) {
              case "liar" -> FleetTest::liar;
              case "filled" -> gvh -> charging(gvh, false);
              case "hasty" -> gvh -> charging(gvh, true);
              case "ungrouped" -> FleetTest::ungrouped;
              default -> FleetTest::unasked;
            });
    assertThat(result.spec().violations(lemma)).as("%s", result.spec().violations()).isPositive();
  }

  @Test
  void robotsOfBothDirectionsPassTheCorridor() {
    Roads roads = new Roads(corridor("tunnel"), BODY_MM, 2);
    SimResult result = run(gvh -> new FleetApp(gvh, roads, BOTH_WAYS, 0, false));
    assertThat(result.unfinished()).isEmpty();
    assertThat(result.spec().violations())
        .filteredOn(violation -> !violation.lemma().equals("fleet.in_time"))
        .isEmpty();
  }

  @ParameterizedTest
  @ValueSource(doubles = {5_000, 15_000})
  void robotsStayOnLongLanes(double laneMm) {
    NavGraph graph = corridor("tunnel", laneMm);
    Roads roads = new Roads(graph, BODY_MM, 2);
    SimResult result = run(graph, gvh -> new FleetApp(gvh, roads, BOTH_WAYS, 0, false));
    assertThat(result.unfinished()).isEmpty();
    assertThat(result.spec().violations("fleet.on_lane")).isZero();
  }
}
