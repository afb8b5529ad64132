package org.starl.apps.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Plan;
import org.starl.apps.search.logic.Drive;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.SearchFact;
import org.starl.apps.search.logic.Sweep;
import org.starl.apps.search.robot.GeneratedHouse;
import org.starl.body.MotionParameters;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Whole searches, and their input files. */
@Tag("long")
class SearchTest {

  @Test
  void theObjectInTheOriginalsHouseIsFound() {
    Map<String, String> files = Map.of("files", Searches.originals().toString());
    assertThat(Searches.answer(Searches.plan(1, 0, files, Map.of("messageLoss", "0.2"))))
        .startsWith("found object1 at 11000,6000 by bot");
  }

  @Test
  void theRoomsOfTheOriginalsHouseAreDerivedFromWallsAndDoors() {
    SearchScene scene = HouseFiles.read(Searches.originals(), 600, MotionParameters.DEFAULT);
    assertThat(scene.house().rooms())
        .extracting(Room::name)
        .containsExactly("A", "B", "C", "D", "E", "F", "G");
    double[] squareMetres = {13, 6.5, 13, 17, 4, 5, 19};
    for (Room room : scene.house().rooms()) {
      double area = room.cells().cardinality() * 0.0025;
      assertThat(area)
          .as("%s", room)
          .isBetween(squareMetres[room.index()] * 0.9, squareMetres[room.index()] * 1.1);
      assertThat(room.isEnterable()).isTrue();
      Sweep sweep = Sweep.of(scene.house(), room, room.door());
      assertThat(sweep.hidden().isEmpty()).as("%s is seen everywhere", room).isTrue();
    }
    assertThat(scene.house().roomAt(scene.things().get(0).at())).isEqualTo(6);
  }

  @ParameterizedTest
  @CsvSource({"0, 8", "200, 4", "1000, 4"})
  void everyGeneratedHouseCanBeSearchedCompletely(long reactionMs, long seeds) {
    // In houses of more than 12 rooms tubes have longer parts, and are wider.
    MotionParameters body = MotionParameters.builder().reactionMs(reactionMs).build();
    for (long seed = 1; seed <= seeds; seed++) {
      HousePlan plan = GeneratedHouse.of((int) (3 * seed), 4, new Rng(seed));
      House house = House.of(plan, 600, Drive.clearanceMm(body, plan.bounds()));
      assertThat(house.rooms()).hasSize((int) (3 * seed)).allMatch(Room::isEnterable);
      Room room = house.room(house.rooms().size() - 1);
      assertThat(Sweep.of(house, room, room.door()).hidden().isEmpty())
          .as("%s of seed %d", room, seed)
          .isTrue();
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {40, 41, 500, 1000})
  void aHouseHasRoomForManyRobots(int robots) {
    HousePlan plan = GeneratedHouse.of(6, robots, new Rng(1));
    House house = House.of(plan, 600, Drive.clearanceMm(MotionParameters.DEFAULT, plan.bounds()));
    assertThat(house.rooms()).hasSize(6).allMatch(Room::isEnterable);
    Searches.plan(1, robots, Map.of(), Map.of()).simulation().build();
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.2", "3, 0", "4, 0.2"})
  void theObjectInAGeneratedHouseIsFound(long seed, String loss) {
    Plan plan = Searches.plan(seed, 3, Map.of("rooms", "3"), Map.of("messageLoss", loss));
    assertThat(Searches.answer(plan)).startsWith("found object at ");
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.2"})
  void aHouseWithoutAnObjectIsAnsweredWithNothingThere(long seed, String loss) {
    Map<String, String> empty = Map.of("rooms", "3", "object", "none");
    assertThat(Searches.answer(Searches.plan(seed, 3, empty, Map.of("messageLoss", loss))))
        .isEqualTo("nothing there");
  }

  @Test
  void robotsWithTheDefaultLimitsOfADeploymentSearchTheWholeHouse() {
    Map<String, String> empty = Map.of("rooms", "2", "object", "none");
    Map<String, String> limits = Map.of("reaction", "200ms", "speedError", "0.1");
    assertThat(Searches.answer(Searches.plan(7, 4, empty, limits))).isEqualTo("nothing there");
  }

  @ParameterizedTest
  @CsvSource({"1, moving", "2, moving", "3, moving", "1, spatial", "2, spatial"})
  void underChaosAllRobotsGiveTheSameAnswer(long seed, String envelope) {
    Searches.answer(Searches.plan(seed, 4, Map.of("rooms", "3"), Map.of("chaos", envelope)));
  }

  @Test
  void twoRobotsThatSeeTheThingAtOnceAgreeOnOneFinder() {
    // In sight of both robots in front: each announces it before it has heard of the other.
    Plan plan =
        Searches.plan(
            1, 4, Map.of("rooms", "2", "object", "8500,1600"), Map.of("messageDelay", "400ms"));
    SortedSet<RobotId> finders = new TreeSet<>();
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof Action action && action.fact() instanceof SearchFact.Found) {
                  finders.add(action.robot());
                }
              }
            });
    assertThat(Searches.answer(plan)).startsWith("found object at 8500,1600 by bot");
    assertThat(finders).hasSizeGreaterThan(1);
  }

  @Test
  void equalSeedsGiveEqualStories() {
    List<String> stories = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Plan plan = Searches.plan(5, 3, Map.of("rooms", "2"), Map.of("messageLoss", "0.2"));
      Searches.answer(plan);
      stories.add(String.join("\n", plan.story().lines()));
    }
    assertThat(stories.get(0)).isEqualTo(stories.get(1));
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
  void aBadParameterIsNamed(String key, String value, String expected) {
    assertThatThrownBy(() -> Searches.plan(1, 3, Map.of(key, value), Map.of()))
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
    "start.wpt, 'WAY,900,900,0,bot0\nWAY,900,1500,0,bot0', 'two robots'",
    "senseObjects.wpt, 'SENSE,1', 'senseObjects.wpt:1:'",
  })
  void aBadLineOfAFileIsNamed(String file, String line, String expected, @TempDir Path folder)
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
