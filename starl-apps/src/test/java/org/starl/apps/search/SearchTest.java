package org.starl.apps.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.RobotId;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchApp;
import org.starl.apps.search.logic.Sweep;
import org.starl.motion.MotionParameters;
import org.starl.random.Rng;
import org.starl.sim.Director;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.input.BadInput;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Whole searches: in every one all specifications hold, and all end with one answer. */
class SearchTest {

  private static final SearchDemo DEMO = new SearchDemo();

  private static Plan plan(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SortedMap<String, String> all = DEMO.defaults();
    all.putAll(parameters);
    OptionalInt count = robots == 0 ? OptionalInt.empty() : OptionalInt.of(robots);
    Request request = new Request(seed, count, all);
    SimSettings.Builder builder = DEMO.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = DEMO.plan(request, builder.build());
    plan.simulation().name("search").seed(seed);
    return plan;
  }

  /** Runs it, and tells the one answer of all that ended. */
  private static String answer(Plan plan) {
    SimResult result = plan.simulation().build().run();
    String story = "seed " + result.seed() + "\n" + String.join("\n", plan.story().lines());
    assertThat(result.spec().violations()).as(story).isEmpty();
    assertThat(result.unfinished()).as(story).isEmpty();
    var answers = new HashSet<String>();
    result.results().values().forEach(ended -> answers.add(ended.get(0).toString()));
    assertThat(answers).as(story).hasSize(1);
    return answers.iterator().next();
  }

  private static Path originals() {
    String shared = System.getProperty("starl.shared", "../../shared");
    Path folder = Path.of(shared, "data", "starl-original", "search");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    return folder;
  }

  @Test
  void inTheOriginalsHouseTheObjectIsFound() {
    Map<String, String> files = Map.of("files", originals().toString());
    assertThat(answer(plan(1, 0, files, Map.of("messageLoss", "0.2"))))
        .startsWith("found object1 at 11000,6000 by bot");
  }

  @Test
  void theOriginalsRoomsFollowFromWallsAndDoors() {
    SearchScene scene = HouseFiles.read(originals(), 600, MotionParameters.DEFAULT);
    assertThat(scene.house().rooms())
        .extracting(Room::name)
        .containsExactly("A", "B", "C", "D", "E", "F", "G");
    double[] squareMetres = {13, 6.5, 13, 17, 4, 5, 19};
    for (Room room : scene.house().rooms()) {
      double area = room.size() * 0.0025;
      assertThat(area)
          .as("%s", room)
          .isBetween(squareMetres[room.index()] * 0.9, squareMetres[room.index()] * 1.1);
      assertThat(room.isEnterable()).isTrue();
      Sweep sweep = Sweep.of(scene.house(), room, room.door());
      assertThat(sweep.hidden().isEmpty()).as("%s is seen everywhere", room).isTrue();
    }
    assertThat(scene.house().roomAt(scene.things().get(0).at())).isEqualTo(6);
  }

  @Test
  void generatedHousesCanBeSearchedEverywhere() {
    for (long seed = 1; seed <= 8; seed++) {
      HousePlan plan = GeneratedHouse.of((int) (3 * seed), 4, new Rng(seed));
      House house =
          House.of(plan, 600, SearchApp.clearanceMm(MotionParameters.DEFAULT, plan.bounds()));
      assertThat(house.rooms()).hasSize((int) (3 * seed)).allMatch(Room::isEnterable);
      Room room = house.room(house.rooms().size() - 1);
      assertThat(Sweep.of(house, room, room.door()).hidden().isEmpty())
          .as("%s of seed %d", room, seed)
          .isTrue();
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.2", "3, 0", "4, 0.2"})
  void whatIsThereIsFound(long seed, String loss) {
    Plan plan = plan(seed, 3, Map.of("rooms", "3"), Map.of("messageLoss", loss));
    assertThat(answer(plan)).startsWith("found object at ");
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.2"})
  void whereNothingIsThatIsTheAnswer(long seed, String loss) {
    Map<String, String> empty = Map.of("rooms", "3", "object", "none");
    assertThat(answer(plan(seed, 3, empty, Map.of("messageLoss", loss))))
        .isEqualTo("nothing there");
  }

  @ParameterizedTest
  @CsvSource({"1, moving", "2, moving", "3, moving", "1, spatial", "2, spatial"})
  void underChaosThereIsOneAnswer(long seed, String envelope) {
    answer(plan(seed, 4, Map.of("rooms", "3"), Map.of("chaos", envelope)));
  }

  @Test
  void twoSeeTheThingAtOnceAndAgreeOnAFinder() {
    // Before the front two, in sight of both: each says so before it has heard of the other.
    Plan plan =
        plan(1, 4, Map.of("rooms", "2", "object", "8500,1600"), Map.of("messageDelay", "400ms"));
    SortedSet<RobotId> finders = new TreeSet<>();
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof Action action && action.name().equals(SearchApp.FOUND)) {
                  finders.add(action.robot());
                }
              }
            });
    assertThat(answer(plan)).startsWith("found object at 8500,1600 by bot");
    assertThat(finders).hasSizeGreaterThan(1);
  }

  /** Crashes a robot of which something is told, for good, soon after that; and looks on. */
  private static final class Killer implements Director, SimObserver {
    private static final long AFTER_NS = 12_000_000_000L;

    private final Director also;
    private final Predicate<Variable> isIt;
    private final Map<RobotId, String> rooms = new TreeMap<>();
    private @Nullable RobotId victim;
    private boolean isDead;
    private boolean isFollowed;
    private boolean isSucceeded;

    Killer(Director also, Predicate<Variable> isIt) {
      this.also = also;
      this.isIt = isIt;
    }

    @Override
    public void observed(TraceEvent event) {
      if (!(event instanceof Variable variable)) {
        return;
      }
      if (victim == null && isIt.test(variable)) {
        victim = variable.robot();
      }
      if (tells(SearchApp.ROOM, "").test(variable)) {
        isFollowed |= isDead && variable.value().equals(rooms.get(victim));
        if (!isDead) {
          rooms.put(variable.robot(), variable.value());
        }
      }
      isSucceeded |= isDead && tells(SearchApp.DUTY, "2").test(variable);
    }

    @Override
    public void direct(SimControl control) {
      also.direct(control);
      look(control);
    }

    private void look(SimControl control) {
      RobotId robot = victim;
      if (robot == null) {
        control.at(control.nowNs() + 50_000_000, () -> look(control));
      } else {
        control.at(
            control.nowNs() + AFTER_NS,
            () -> {
              isDead = true;
              control.crash(robot);
            });
      }
    }
  }

  private static Predicate<Variable> tells(String name, String value) {
    return variable ->
        variable.source().equals(SearchApp.SOURCE)
            && variable.name().equals(name)
            && variable.value().startsWith(value);
  }

  private static Predicate<Variable> leadersSweep() {
    SortedSet<RobotId> leaders = new TreeSet<>();
    return variable -> {
      if (tells(SearchApp.DUTY, "1 ").test(variable)) {
        leaders.add(variable.robot());
      }
      return leaders.contains(variable.robot())
          && tells(SearchApp.LOCATION, "SWEEP").test(variable);
    };
  }

  @Test
  void whenTheLeaderDiesAnotherOneGoesOn() {
    for (long seed = 1; seed <= 3; seed++) {
      assertThat(killed(seed, leadersSweep()).isSucceeded).as("seed %d", seed).isTrue();
    }
  }

  @Test
  void theRoomOfASearcherThatDiesInItIsGivenToAnother() {
    for (long seed = 4; seed <= 6; seed++) {
      Killer killer = killed(seed, tells(SearchApp.LOCATION, "SWEEP"));
      assertThat(killer.isFollowed).as("seed %d", seed).isTrue();
    }
  }

  /** All but the room of the dead is searched in full; that one as far as the dead does not bar it. */
  private static Killer killed(long seed, Predicate<Variable> isIt) {
    Map<String, String> empty = Map.of("rooms", "4", "object", "none");
    Plan plan = plan(seed, 3, empty, Map.of("messageLoss", "0.1"));
    Director sensors = plan.simulation().build().blueprint().director();
    Killer killer = new Killer(sensors == null ? control -> {} : sensors, isIt);
    plan.simulation().director(killer).observer(killer);
    String answer = answer(plan);
    String room = killer.rooms.get(killer.victim);
    assertThat(answer)
        .as("seed %d\n%s", seed, String.join("\n", plan.story().lines()))
        .isIn("nothing there", "gave up, could not search " + room);
    return killer;
  }

  @Test
  void equalSeedsGiveEqualRuns() {
    List<String> first = new java.util.ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Plan plan = plan(5, 3, Map.of("rooms", "2"), Map.of("messageLoss", "0.2"));
      answer(plan);
      first.add(String.join("\n", plan.story().lines()));
    }
    assertThat(first.get(0)).isEqualTo(first.get(1));
  }

  @ParameterizedTest
  @CsvSource({
    "rooms, 0, rooms",
    "rooms, 25, rooms",
    "scenario, maze, 'expected generated or files'",
    "scenario, files, 'expected the folder'",
    "object, here, object",
    "object, '1', 'expected drawn, none or x,y'",
    "object, '-5000,0', 'expected drawn, none or x,y'",
    "files, /nowhere, 'no such file'",
  })
  void badParametersAreNamed(String key, String value, String expected) {
    assertThatThrownBy(() -> plan(1, 3, Map.of(key, value), Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "obstacles.wpt, 'Obstacle;1,1;2;-1', 'obstacles.wpt:1:'",
    "obstacles.wpt, '// none', 'expected walls'",
    "obstacles.wpt, 'Hidden;0,0;9,0;-1', 'stand for ever'",
    "dest.wpt, 'WAY,1,x,0,A', 'dest.wpt:1:'",
    "dest.wpt, '', 'expected doors'",
    "dest.wpt, 'WAY,50,900,0,A', 'door A'",
    "start.wpt, 'WAY,900,900,0,7', 'robot''s name'",
    "senseObjects.wpt, 'SENSE,1', 'senseObjects.wpt:1:'",
  })
  void badLinesAreNamed(String file, String line, String expected, @TempDir Path folder)
      throws IOException {
    Files.writeString(
        folder.resolve("obstacles.wpt"),
        "Obstacle;0,0;4000,0;4000,4000;0,4000;0,3900;3900,3900;3900,100;0,100;-1\n"
            + "Obstacle;0,0;100,0;100,4000;0,4000;-1\n"
            + "Obstacle;100,2000;1500,2000;1500,2100;100,2100;-1\n"
            + "Obstacle;2400,2000;3900,2000;3900,2100;2400,2100;-1\n");
    Files.writeString(folder.resolve("dest.wpt"), "WAY,1950,2050,0,A\n");
    Files.writeString(folder.resolve("start.wpt"), "WAY,1000,1000,0,bot0\n");
    Files.writeString(folder.resolve("senseObjects.wpt"), "SENSE,3000,3000,0,thing\n");
    assertThat(HouseFiles.read(folder, 600, MotionParameters.DEFAULT).house().rooms()).hasSize(1);
    Files.writeString(folder.resolve(file), line);
    assertThatThrownBy(() -> HouseFiles.read(folder, 600, MotionParameters.DEFAULT))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(expected);
  }
}
