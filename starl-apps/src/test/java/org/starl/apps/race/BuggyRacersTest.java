package org.starl.apps.race;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.race.logic.BuggyRacer;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.robot.RaceFactory;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** The monitor of its lemma reports each planted bug of {@link BuggyRacer}. */
class BuggyRacersTest {

  private static final int SEEDS = 20;

  private static SimResult run(BuggyRacer.Bug bug, long seed) {
    // Bodies pass through each other and messages are slow: sometimes two robots arrive at once.
    SimSettings settings =
        SimSettings.builder()
            .set("duration", "600s")
            .set("idealMotion", "true")
            .set("messageDelay", "uniform(500ms,3s)")
            .set("robots", "6")
            // So far that a robot that hears nothing does not arrive before it should know.
            .set("floorWidth", bug == BuggyRacer.Bug.ANNOUNCES_NOTHING ? "30m" : "5m")
            .build();
    List<RacePoint> points =
        RaceFactory.drawn(
            4,
            settings.get(Setting.FLOOR_WIDTH),
            settings.get(Setting.FLOOR_HEIGHT),
            new Rng(seed).fork("race"));
    Simulation.Builder simulation =
        Simulation.builder()
            .seed(seed)
            .settings(settings)
            .robots(settings.robots(), gvh -> new BuggyRacer(gvh, points, bug));
    RaceDemo.watch(simulation, points, settings);
    return simulation.build().run();
  }

  @ParameterizedTest
  @CsvSource({
    "CLAIMS_FROM_AFAR, race.at_the_point",
    "ANNOUNCES_ANOTHER_WINNER, race.truly_won",
    "LAST_HEARD_COUNTS, race.one_winner",
    "ANNOUNCES_NOTHING, race.told",
    "DOES_NOT_DRIVE, race.taken",
    "FIRST_HEARD_COUNTS, race.agreed",
    "RACES_ON, race.moves_on",
    "DOES_NOT_WAIT, race.confirmed",
    "MAKES_WAY_BRIEFLY, race.makes_way",
  })
  void aBuggyRacerIsSeen(BuggyRacer.Bug bug, String lemma) {
    long seed = 0;
    SimResult result;
    do {
      seed++;
      result = run(bug, seed);
    } while (result.spec().violations(lemma) == 0 && seed < SEEDS);
    assertThat(result.spec().violations(lemma)).as("%s, seeds 1..%d", bug, SEEDS).isPositive();
  }
}
