package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;

class IntersectionTest {

  static Request request(long seed, int robots, Map<String, String> parameters) {
    SortedMap<String, String> all = new TreeMap<>();
    for (Parameter parameter : new IntersectionDemo().parameters()) {
      all.put(parameter.key(), parameter.defaultValue());
    }
    all.putAll(parameters);
    return new Request(seed, robots == 0 ? OptionalInt.empty() : OptionalInt.of(robots), all);
  }

  static SimResult run(Request request, Map<String, String> settings, SimObserver... observers) {
    IntersectionDemo demo = new IntersectionDemo();
    SimSettings.Builder builder = demo.defaultSettings(request).set("duration", "1200s");
    settings.forEach(builder::set);
    Plan plan = demo.plan(request, builder.build());
    for (SimObserver observer : observers) {
      plan.simulation().observer(observer);
    }
    SimResult result = plan.simulation().name("intersection").seed(request.seed()).build().run();
    assertThat(result.spec().violations())
        .as("seed %d %s\n%s", request.seed(), settings, String.join("\n", plan.story().lines()))
        .isEmpty();
    assertThat(result.unfinished())
        .as("seed %d %s\n%s", request.seed(), settings, String.join("\n", plan.story().lines()))
        .isEmpty();
    return result;
  }

  @Test
  void figure7CrossesSafely() {
    run(request(1, 0, Map.of("scenario", "figure7")), Map.of());
  }

  @ParameterizedTest
  @CsvSource({"1, randomRobots", "20, randomRobots", "5, discoveryRobots"})
  void carsThatLeaveTheirWayAreNotRequiredToKeepToTheirZones(long seed, String setting) {
    SimResult result = run(request(seed, 6, Map.of()), Map.of(setting, "2"));
    assertThat(result.spec().exceptions())
        .containsExactly(
            "not required of bot4 bot5, which leave their way: intersection.traffic_safety"
                + " intersection.occupied_is_held",
            "not required of bot4 bot5, which leave their way: intersection.traffic_progress");
  }

  @Test
  void everySpecificationIsRequiredOfOrdinaryCars() {
    assertThat(run(request(1, 0, Map.of()), Map.of()).spec().exceptions()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void carsCrossUnderChaos(long seed) {
    run(request(seed, 6, Map.of()), Map.of("chaos", "moving"));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void drawnCarsCross(long seed) {
    run(
        request(seed, 4, Map.of()),
        Map.of("messageLoss", "0.3", "messageDelay", "uniform(10ms,200ms)"));
  }

  @ParameterizedTest
  @CsvSource({"7, none", "8, moving", "9, moving", "10, moving"})
  void carsThatRunFigure3Cross(long seed, String chaos) {
    run(request(seed, 6, Map.of("car", "program")), Map.of("messageLoss", "0.3", "chaos", chaos));
  }

  @Test
  void anUnknownProgramOfCarsIsRefused() {
    Request request = request(1, 2, Map.of("car", "lorry"));
    SimSettings settings = new IntersectionDemo().defaultSettings(request).build();
    assertThatExceptionOfType(BadInput.class)
        .isThrownBy(() -> new IntersectionDemo().plan(request, settings))
        .withMessage("car: 'lorry': expected one of flow, paper, program");
  }

  @Test
  void twelveCarsCross() {
    run(request(5, 12, Map.of()), Map.of());
  }
}
