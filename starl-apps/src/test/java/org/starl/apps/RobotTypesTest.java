package org.starl.apps;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.apps.hello.HelloDemo;
import org.starl.apps.lightpaint.LightPaintDemo;
import org.starl.apps.race.RaceDemo;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.trace.TraceEvent;

/** Random movers and discovery robots change runs, under the apps' own collision policies. */
class RobotTypesTest {

  private static List<String> events(Demo demo, long seed, String key, int count) {
    Request request = new Request(seed, OptionalInt.empty(), demo.defaults());
    SimSettings settings =
        SimSettings.builder()
            .set("duration", "3600s")
            .set(key, Integer.toString(count))
            .build()
            .over(demo.defaultSettings(request).build());
    List<String> events = new ArrayList<>();
    SimResult result =
        demo.plan(request, settings)
            .simulation()
            .name(demo.name())
            .seed(seed)
            .observer(
                new SimObserver() {
                  @Override
                  public void observed(TraceEvent event) {
                    events.add(event.toString());
                  }
                })
            .build()
            .run();
    assertThat(result.spec().holds()).as("%s", result.spec().violations()).isTrue();
    assertThat(result.isFinished()).as("%s", result.diagnosis()).isTrue();
    return events;
  }

  @Test
  @Tag("long")
  void randomMoversChangeEveryAppThatMoves() {
    for (Demo demo : List.of(new HelloDemo(), new RaceDemo(), new LightPaintDemo())) {
      assertThat(events(demo, 1, "randomRobots", 2))
          .as(demo.name())
          .isNotEqualTo(events(demo, 1, "randomRobots", 0));
    }
  }

  @Test
  @Tag("long")
  void discoveryRobotsChangeARaceWithBumps() {
    Demo race = new RaceDemo();
    assertThat(events(race, 1, "discoveryRobots", 4))
        .isNotEqualTo(events(race, 1, "discoveryRobots", 0));
  }
}
