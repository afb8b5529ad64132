package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.cli.command.Apps;
import org.starl.cli.request.ScenarioFile;
import org.starl.id.RobotId;
import org.starl.robot.LocalSpecs;
import org.starl.sim.SimObserver;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** The lemmas that a deployed robot checks by itself raise no false alarm. */
class OwnLemmasTest {

  private static final int SEED = 3;

  static Stream<Demo> demos() {
    return Apps.ALL.all().stream()
        .filter(demo -> !watch(demo, new ArrayList<>()).lemmas().isEmpty());
  }

  private static LocalSpecs watch(Demo demo, List<Violation> violations) {
    return new LocalSpecs(plan(demo).simulation().build().plan().monitors(), 0, violations::add);
  }

  private static Plan plan(Demo demo) {
    Map<String, String> settings = new LinkedHashMap<>();
    settings.put("messageLoss", "0.1");
    settings.put("chaos", demo.envelope().toString());
    settings.put("chaosFor", "10s");
    settings.put("duration", "40s");
    ScenarioFile file = new ScenarioFile("", demo.name(), settings, Map.of());
    return file.request(Apps.ALL).build().plan(SEED);
  }

  @ParameterizedTest
  @MethodSource("demos")
  void aCorrectRunViolatesNoLemmaOfOneRobot(Demo demo) {
    List<TraceEvent> all = new ArrayList<>();
    Plan plan = plan(demo);
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                all.add(event);
              }
            })
        .build()
        .run();

    // Each start of a program is another process, with specifications of its own.
    Map<RobotId, LocalSpecs> processes = new TreeMap<>();
    List<Violation> violations = new ArrayList<>();
    for (TraceEvent event : all) {
      if (event instanceof Fault fault && fault.name().equals(Fault.RESTART)) {
        processes.remove(fault.robot());
      } else {
        processes.computeIfAbsent(event.robot(), robot -> watch(demo, violations)).observed(event);
      }
    }

    assertThat(all).isNotEmpty();
    assertThat(violations).as("seed %d of %s", SEED, demo.name()).isEmpty();
  }
}
