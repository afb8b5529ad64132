package org.starl.apps.maze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.maze.robot.Layout;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridMaps;

class MazeTest {

  private static final MazeDemo DEMO = new MazeDemo();

  private static Plan plan(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SortedMap<String, String> all = DEMO.defaults();
    all.putAll(parameters);
    Request request = new Request(seed, OptionalInt.of(robots), all);
    SimSettings.Builder builder = DEMO.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = DEMO.plan(request, builder.build());
    plan.simulation().name("maze").seed(seed);
    return plan;
  }

  /** Runs a maze in which every goal must be answered truly and no robot may give up. */
  private static SimResult run(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    Plan plan = plan(seed, robots, parameters, settings);
    SimResult result = plan.simulation().build().run();
    String which = "seed " + seed + ", " + robots + " robots, " + parameters + settings;
    assertThat(result.spec().violations()).as(which).isEmpty();
    assertThat(result.unfinished()).as(which).isEmpty();
    assertThat(plan.story().measures().counts().get("gave up")).as(which).isZero();
    return result;
  }

  private static List<Object> answers(SimResult result, int robot) {
    return result.results().get(new RobotId("bot" + robot));
  }

  /** With these seeds obstacles lead to where another robot rests. */
  @ParameterizedTest
  @ValueSource(longs = {17, 18, 20})
  @Tag("long")
  void aRobotThatDrivesAlongAnObstacleStopsBeforeOneThatRests(long seed) {
    run(seed, 3, Map.of("collision", "discover"), Map.of());
  }

  /** Its wheels slip, so it believes to have arrived too early, and a fix tells it before it answers. */
  @Test
  void chaosDrawsEachCollisionMode() {
    SortedSet<String> modes = new TreeSet<>();
    for (long seed = 1; seed <= 20; seed++) {
      Request request = new Request(seed, OptionalInt.empty(), DEMO.defaults(), Set.of());
      modes.add(DEMO.varied(request).parameter("collision"));
    }
    assertThat(modes).containsExactly("back", "discover", "stop");
  }

  @Test
  void aRobotThatLearnsOnItsArrivalThatItIsNotThereDrivesOn() {
    for (long seed = 1; seed <= 10; seed++) {
      Plan plan = plan(seed, 1, Map.of("hidden", "0"), Map.of("positionPeriod", "200ms"));
      plan.simulation().fault("slow(bot0,0.4,at=1s)");
      SimResult result = plan.simulation().build().run();
      assertThat(result.spec().violations()).as("seed " + seed).isEmpty();
    }
  }

  private static Path shared(String what) {
    Path path =
        Path.of(System.getProperty("starl.shared", "../../shared")).resolve("data").resolve(what);
    assumeTrue(Files.exists(path), "skipped: no " + path + " (set -Dstarl.shared)");
    return path;
  }

  @ParameterizedTest
  @ValueSource(strings = {"back", "stop", "discover"})
  @Tag("long")
  void goalsAreReachedOrProvenToBeCutOff(String collision) {
    for (long seed = 1; seed <= 2; seed++) {
      String loss = seed % 2 == 0 ? "0.2" : "0";
      run(seed, 3, Map.of("collision", collision), Map.of("messageLoss", loss));
    }
  }

  @Test
  @Tag("long")
  void goalsAreAnsweredUnderChaos() {
    for (long seed = 11; seed <= 14; seed++) {
      run(seed, 3, Map.of(), Map.of("chaos", "spatial"));
    }
  }

  @Test
  void goalsAreAnsweredWithInexactPositionsAndWheels() {
    run(5, 2, Map.of(), Map.of("positionNoise", "15mm", "speedError", "0.05"));
  }

  @Test
  void oneGoalOfTheOriginalsMazeIsReached() {
    Path folder = shared("starl-original/maze");
    SimResult result = run(3, 1, Map.of("files", folder.toString()), Map.of());
    // A wall as high as the floor stands between the two goals.
    assertThat(answers(result, 0))
        .isIn(List.of("E REACHED", "Final NO_WAY"), List.of("E NO_WAY", "Final REACHED"));
  }

  @ParameterizedTest
  @Tag("long")
  @CsvSource({"maze-32-32-4, 6", "empty-48-48, 8", "ht_chantry, 4"})
  void goalsAreAnsweredOnGridMaps(String map, int robots) {
    Path file = shared("maps/" + map + ".map");
    run(2, robots, Map.of("map", file.toString()), Map.of("messageLoss", "0.2"));
  }

  private static final String ROOM =
      """
      Hidden;2000,1000;3000,1000;-1
      Hidden;3000,1000;3000,2000;-1
      Hidden;3000,2000;2000,2000;-1
      """;

  private static Path folder(Path folder, String obstacles, String start, String... goals)
      throws IOException {
    Files.writeString(folder.resolve("obstacles.wpt"), obstacles);
    Files.writeString(folder.resolve("start.wpt"), start);
    Files.writeString(folder.resolve("dest.wpt"), String.join("\n", goals));
    return folder;
  }

  @ParameterizedTest
  @CsvSource({"1000, REACHED", "700, REACHED", "500, REACHED", "300, NO_WAY", "0, NO_WAY"})
  void aHiddenRoomIsEnteredExactlyIfItsDoorFitsBodyAndMargin(
      int doorMm, String answer, @TempDir Path folder) throws IOException {
    int half = doorMm / 2;
    String door =
        "Hidden;2000,1000;2000,"
            + (1500 - half)
            + ";-1\n"
            + "Hidden;2000,"
            + (1500 + half)
            + ";2000,2000;-1\n";
    folder(folder, ROOM + door, "WAY,4300,1500,180,bot0", "WAY,2500,1500,0,room,20");
    SimResult result = run(1, 1, Map.of("files", folder.toString()), Map.of());
    assertThat(answers(result, 0)).containsExactly("room " + answer);
  }

  @ParameterizedTest
  @ValueSource(ints = {340, 360, 400, 440, 470})
  @Tag("long")
  void bothAnswersAreRightForADoorBetweenBodyAndMargin(int doorMm, @TempDir Path folder)
      throws IOException {
    int half = doorMm / 2;
    String door =
        "Hidden;2000,1000;2000,"
            + (1500 - half)
            + ";-1\n"
            + "Hidden;2000,"
            + (1500 + half)
            + ";2000,2000;-1\n";
    // It starts inside and may get out; both goals must be answered anyway.
    folder(
        folder,
        ROOM + door,
        "WAY,2600,1500,180,bot0",
        "WAY,1000,1500,0,outside,20",
        "WAY,2700,1700,0,inside,20");
    Plan plan = plan(1, 1, Map.of("files", folder.toString()), Map.of());
    SimResult result = plan.simulation().build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.unfinished()).isEmpty();
    assertThat(answers(result, 0)).hasSize(2);
  }

  @Test
  void aGoalOutsideClosedWallsOrInsideAnObstacleIsUnreachable(@TempDir Path folder)
      throws IOException {
    String wall = "Hidden;2000,1000;2000,2000;-1\n";
    folder(
        folder,
        ROOM + wall + "Obstacle;4000,2000;4500,2000;4500,2500;4000,2500;-1\n",
        "WAY,2500,1500,0,bot0",
        "WAY,1000,1500,0,outside",
        "WAY,4200,2200,0,block",
        "WAY,2500,1400,0,inside");
    SimResult result = run(1, 1, Map.of("files", folder.toString()), Map.of());
    assertThat(answers(result, 0))
        .containsExactly("outside NO_WAY", "block NO_WAY", "inside REACHED");
  }

  @Test
  void aHiddenWallIsFeltAlongByOneRobotForAll(@TempDir Path folder) throws IOException {
    String wall = "Hidden;0,2500;3500,2500;-1\n";
    folder(folder, wall, "WAY,700,700,0,bot0", "WAY,700,4300,0,north,20");
    long alone = contacts(folder, 1);
    folder(
        folder,
        wall,
        "WAY,700,700,0,bot0\nWAY,1700,700,0,bot1",
        "WAY,700,4300,0,north,20",
        "WAY,1700,4300,0,beside,20");
    assertThat(contacts(folder, 2)).isLessThan(alone + 4);
  }

  private static long contacts(Path folder, int robots) {
    Map<String, String> floor = Map.of("floorWidth", "5m", "floorHeight", "5m");
    Plan plan = plan(1, robots, Map.of("files", folder.toString()), floor);
    assertThat(plan.simulation().build().run().spec().violations()).isEmpty();
    return plan.story().measures().counts().get("contacts");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          robots=33 | expected 1 to 32 in a maze
          robots=32 | in this maze; expected fewer robots or a larger maze: each robot has a goal
          collision=bounce | collision: 'bounce': expected one of stop, back, discover
          hidden=2 | hidden: '2': expected a probability from 0 to 1
          scenario=files | expected drawn, files with files=FOLDER, or map with map=FILE
          scenario=labyrinth | expected drawn, files with files=FOLDER, or map with map=FILE
          files=nowhere | nowhere/dest.wpt: no such file
          map=nowhere.map | nowhere.map: no such file
          scen=a.scen | scen is set without map: expected map=FILE
          """)
  void badParametersAreReported(String setting, String message) {
    String key = setting.substring(0, setting.indexOf('='));
    String value = setting.substring(setting.indexOf('=') + 1);
    boolean isRobots = key.equals("robots");
    int robots = isRobots ? Integer.parseInt(value) : 1;
    Map<String, String> parameters = isRobots ? Map.of() : Map.of(key, value);
    assertThatThrownBy(() -> plan(1, robots, parameters, Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(message);
  }

  @Test
  void badFilesAreReported(@TempDir Path folder) throws IOException {
    Map<String, String> files = Map.of("files", folder.toString());
    folder(folder, "Hidden;0,0;1,1;500", "WAY,500,500,0,bot0", "WAY,1500,1500,0,A");
    assertThatThrownBy(() -> plan(1, 1, files, Map.of()))
        .hasMessageContaining("an obstacle with lifetime 500: expected -1");
    folder(folder, "", "WAY,500,500,0,bot0", "WAY,9000,1500,0,A");
    assertThatThrownBy(() -> plan(1, 1, files, Map.of()))
        .hasMessageContaining("A at 9000.0,1500.0: expected a place on the floor");
    folder(folder, "", "WAY,500,500,0,bot0", "// nothing");
    assertThatThrownBy(() -> plan(1, 1, files, Map.of())).hasMessageContaining("no goal");
    folder(folder, "", "WAY,500,500,0,bot0", "WAY,1500,1500,0,A");
    assertThatThrownBy(() -> plan(1, 2, files, Map.of()))
        .hasMessageContaining("start.wpt: 1 starts: expected 2");
    folder(folder, "Wall;0,0", "WAY,500,500,0,bot0", "WAY,1500,1500,0,A");
    assertThatThrownBy(() -> plan(1, 1, files, Map.of()))
        .hasMessageContaining("obstacles.wpt:1: 'Wall;0,0': expected");
  }

  private static final String MAP = "height 4\nwidth 6\nmap\n......\n.@@@..\n......\n......\n";

  private static Map<String, String> list(Path folder, String lines) throws IOException {
    Path map = Files.writeString(folder.resolve("a.map"), MAP);
    Path list = Files.writeString(folder.resolve("a.scen"), lines);
    return Map.of("map", map.toString(), "scen", list.toString(), "hidden", "0");
  }

  @Test
  void robotsDriveFromTheStartsToTheGoalsOfAList(@TempDir Path folder) throws IOException {
    String lines =
        "version 1\n0\ta map.map\t6\t4\t0\t0\t5\t3\t9\n"
            + "0\ta.map\t6\t4\t5\t0\t0\t3\t9\n0\ta.map\t6\t4\t9\t9\t9\t9\t9\n";
    Plan plan = plan(1, 2, list(folder, lines), Map.of());
    SimResult result = plan.simulation().build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(answers(result, 0)).containsExactly("G0 REACHED");
    assertThat(answers(result, 1)).containsExactly("G1 REACHED");
    GridMap map = GridMaps.read(folder.resolve("a.map"));
    Layout layout = MapMaze.of(map, folder.resolve("a.scen"), 500, 1, 0, new Rng(1));
    assertThat(layout.robots().get(0).start().at()).isEqualTo(new Point(250, 1750));
    assertThat(layout.robots().get(0).goals().get(0).at()).isEqualTo(new Point(2750, 250));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          0 a.map 6 4 0 0 5 3 9 | a.scen:1: '0 a.map 6 4 0 0 5 3 9': expected 'version 1'
          version 1/0 a.map 6 4 0 0 | a.scen:2: '0 a.map 6 4 0 0': expected BUCKET MAP WIDTH HEIGHT STARTX STARTY
          version 1/0 a.map 5 4 0 0 5 3 9 | a.scen:2: '5': expected a whole number from 6 to 6
          version 1//0 a.map 6 4 1 1 5 3 9 | a.scen:3: '1 1': expected a free cell of the map
          version 2/0 a.map 6 4 0 0 5 3 9 | a.scen:1: 'version 2': expected 'version 1'
          version 1/x a.map 6 4 0 0 5 3 9 | a.scen:2: 'x': expected a whole number of at least 0
          version 1/0 a.map 6 4 0 0 5 3 far | a.scen:2: 'far': expected a number of at least 0
          version 1/0 a.map 6 4 0 0 5 3 9/0 a.map 6 4 1 3 5 0 9/end | a.scen:4: 'end': expected BUCKET MAP
          version 1/0 a.map 6 4 0 x 5 3 9 | a.scen:2: 'x': expected a whole number from 0 to 3
          version 1/0 a.map 6 4 0 0 5 3 9/0 a.map 6 4 5 3 1 3 9 | a.scen:3: '0 a.map 6 4 5 3 1 3 9': expected a start and a goal off
          version 1.0/0 a.map 6 4 0 0 5 3 9 | a.scen: 1 starts: expected 2, one per robot
          """)
  void badListsAreReported(String lines, String message, @TempDir Path folder) throws IOException {
    Map<String, String> list = list(folder, lines.replace("/", "\n"));
    assertThatThrownBy(() -> plan(1, 2, list, Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(message);
  }

  @Test
  void mapsOfTooManyWallsAreRefused(@TempDir Path folder) throws IOException {
    String rows = ("@.".repeat(200) + "\n" + ".@".repeat(200) + "\n").repeat(201);
    Path map = folder.resolve("a.map");
    Files.writeString(map, "height 402\nwidth 400\nmap\n" + rows);
    assertThatThrownBy(() -> plan(1, 1, Map.of("map", map.toString()), Map.of()))
        .hasMessage("map: 80400 rectangles of blocked cells: expected at most 80000");
  }

  @Test
  void aCellMustFitABodyAndItsMargin() {
    Path file = shared("maps/maze-32-32-4.map");
    Map<String, String> parameters = Map.of("map", file.toString(), "cell", "400mm");
    assertThatThrownBy(() -> plan(1, 4, parameters, Map.of()))
        .hasMessage("cell: '400mm': expected a distance from 500mm to 10m");
  }

  @Test
  void aRobotThatWandersIsNotRequiredToKeepApart() {
    Plan plan = plan(1, 4, Map.of(), Map.of("randomRobots", "1", "duration", "1s"));
    assertThat(plan.simulation().build().run().spec().exceptions())
        .containsExactly("not required of bot3, which leave their way: maze.Apart maze.held");
  }
}
