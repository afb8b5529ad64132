package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.AppFactory;
import org.starl.apps.Demo;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.body.MotionParameters;
import org.starl.cli.command.Apps;
import org.starl.input.BadInput;
import org.starl.robot.LocalSpecs;
import org.starl.robot.RealMotion;
import org.starl.robot.file.Limits;
import org.starl.sim.SimSettings;
import org.starl.sim.SimulationPlan;
import org.starl.spec.Monitor;

/** What phones run of StarL's apps is what boards and the simulator run. */
class AppFactoriesTest {

  /** A search of robots without sensors has nothing to find. */
  private static final Map<String, Map<String, String>> GIVEN =
      Map.of("search", Map.of("object", "none"));

  static List<String> names() {
    return Apps.OWN.names();
  }

  private static Request request(AppFactory factory, int robots) {
    SortedMap<String, String> parameters = factory.defaults();
    parameters.putAll(GIVEN.getOrDefault(factory.name(), Map.of()));
    return new Request(7, OptionalInt.of(robots), parameters);
  }

  private static List<String> ownLemmas(List<? extends Supplier<? extends Monitor>> monitors) {
    return new LocalSpecs(monitors, 0, violation -> {}).lemmas().stream().sorted().toList();
  }

  @Test
  void everyAppHasAFactory() {
    assertThat(AppFactory.installed().keySet()).containsExactlyElementsOf(names());
  }

  @ParameterizedTest
  @MethodSource("names")
  void aPhoneAndABoardHaveOneMapAndCheckTheSameLemmas(String name) {
    AppFactory factory = AppFactory.installed().get(name);
    Demo demo = Apps.OWN.byName(name).orElseThrow();
    assertThat(demo.parameters()).isEqualTo(factory.parameters());
    Request request = request(factory, 4);
    RobotProgram program = factory.program(request);
    SimulationPlan plan =
        demo.plan(request, demo.defaultSettings(request).build()).simulation().build().plan();
    assertThat(program.knownObstacles()).isEqualTo(plan.obstacles().known());
    assertThat(ownLemmas(program.monitors())).isEqualTo(ownLemmas(plan.monitors()));
  }

  @ParameterizedTest
  @MethodSource("names")
  void theMapsAllowForTheDeploymentsLimits(String name) {
    AppFactory factory = AppFactory.installed().get(name);
    Demo demo = Apps.OWN.byName(name).orElseThrow();
    SimSettings errors =
        SimSettings.builder().set("reaction", "200ms").set("speedError", "0.1").build();
    MotionParameters motion =
        RealMotion.of(MotionParameters.DEFAULT, new Limits(500, 300, 500, 0.1, 200));
    Request usual = request(factory, 4);
    Request request = new Request(7, usual.robots(), usual.parameters(), Set.of(), motion);

    SimSettings settings = errors.over(demo.defaultSettings(request).build());
    SimulationPlan plan = demo.plan(request, settings).simulation().build().plan();

    assertThat(factory.program(request).knownObstacles()).isEqualTo(plan.obstacles().known());
  }

  @ParameterizedTest
  @MethodSource("names")
  void aFileThatOnlyTheSimulatorReadsIsRefusedInOneLine(String name) {
    AppFactory factory = AppFactory.installed().get(name);
    for (String key : List.of("files", "points", "map", "drawing", "starts")) {
      if (factory.defaults().containsKey(key)) {
        Request request = request(factory, 2);
        request.parameters().put(key, "my.wpt");
        assertThatThrownBy(() -> factory.program(request))
            .isInstanceOf(BadInput.class)
            .hasMessage(key + "='my.wpt': expected none on robots without the simulator");
      }
    }
  }
}
