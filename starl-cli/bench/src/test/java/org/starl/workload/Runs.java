package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.id.RobotId;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;

/** Runs workloads, and the intersection, as the command line does. */
public final class Runs {

  private Runs() {}

  public static Demo demo(String name) {
    return Stream.concat(PrimitiveWorkloads.ALL.stream(), Stream.of(new IntersectionDemo()))
        .filter(demo -> demo.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /**
   * @param set parameters and settings alike, as {@code --set} takes them
   */
  public static Plan plan(String name, long seed, Map<String, String> set) {
    return plan(name, seed, OptionalInt.empty(), set);
  }

  static Plan plan(String name, long seed, OptionalInt robots, Map<String, String> set) {
    Demo demo = demo(name);
    SortedMap<String, String> parameters = new TreeMap<>();
    demo.parameters().forEach(p -> parameters.put(p.key(), p.defaultValue()));
    SortedMap<String, String> settings = new TreeMap<>(Map.of("duration", "1200s"));
    set.forEach(
        (key, value) -> (parameters.containsKey(key) ? parameters : settings).put(key, value));
    Request request = new Request(seed, robots, parameters);
    SimSettings.Builder builder = demo.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = demo.plan(request, builder.build());
    plan.simulation().name(name).seed(seed);
    return plan;
  }

  /**
   * The result of a run.
   *
   * @param faults how many have begun
   * @param servedAfterHealing how often each robot was served after the last fault
   */
  record Ended(SimResult result, long faults, SortedMap<RobotId, Integer> servedAfterHealing) {}

  static Ended run(Plan plan) {
    List<String> faults = new ArrayList<>();
    SortedMap<RobotId, Integer> served = new TreeMap<>();
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof Fault fault) {
                  if (fault.name().equals(Fault.BEGIN)) {
                    faults.add(fault.detail());
                  } else if (fault.name().equals(Fault.HEALED)) {
                    served.clear();
                  }
                } else if (event instanceof Action action
                    && action.fact() instanceof ClientFact.served) {
                  served.merge(action.robot(), 1, Integer::sum);
                }
              }
            });
    SimResult result = plan.simulation().build().run();
    return new Ended(result, faults.size(), served);
  }
}
