package org.starl.bench;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.IntConsumer;
import org.starl.apps.Demo;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.sim.OrderObserver;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.net.Transmission;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * B5: how much behaviour a second of one core checks. Runs the intersection with 4 cars on drawn
 * routes under the faults of its chaos, a new seed each time, with all monitors. A step is one action
 * of one robot: the code between two waits, a handler, a timer.
 */
public final class CheckSpeed {

  /** Name in {@code starl bench NAME}. */
  public static final String NAME = "b5";

  /** One line for people. */
  public static final String SUMMARY =
      "steps and runs per second of the intersection with 4 cars, faults and monitors";

  private static final int CARS = 4;

  private CheckSpeed() {}

  /**
   * What some runs took.
   *
   * @param events of the kernel; those that ran on robots are the steps
   * @param violated number of runs that violated a specification
   */
  public record Speed(
      int runs, long steps, long events, double simulatedS, double cpuS, int violated) {

    /** The figures in display order. */
    public Map<String, Object> asMap() {
      Map<String, Object> map = new LinkedHashMap<>();
      map.put("workload", NAME);
      map.put("n", CARS);
      map.put("runs", runs);
      map.put("steps", steps);
      map.put("events", events);
      map.put("steps_per_cpu_s", Math.round(steps / cpuS));
      map.put("runs_per_cpu_s", runs / cpuS);
      map.put("rtf", simulatedS / cpuS);
      map.put("cpu_s", cpuS);
      map.put("violated", violated);
      map.put("jvm", Runtime.version().toString());
      return map;
    }
  }

  /** Counts the steps of a run, which it changes in nothing. */
  private static final class StepCounter implements OrderObserver {
    private long steps;

    @Override
    public void ran(long timeNs, String robot) {
      if (!robot.isEmpty()) {
        steps++;
      }
    }

    @Override
    public void sent(Transmission copy, long delayNs) {}

    @Override
    public void observed(TraceEvent event) {}
  }

  /**
   * Runs {@code runs} seeds from {@code firstSeed} on, on this thread, after as many others that
   * warm the JVM up; then runs them again to count their steps.
   *
   * @param afterRun called with the number of runs so far, of three times {@code runs}
   */
  public static Speed take(int runs, long firstSeed, IntConsumer afterRun) {
    int done = 0;
    for (int i = 0; i < runs; i++) {
      simulation(firstSeed + runs + i).build().runOnThisThread();
      afterRun.accept(++done);
    }
    int bad = 0;
    double simulatedS = 0;
    long events = 0;
    long startNs = Measurement.cpuNs();
    for (int i = 0; i < runs; i++) {
      SimResult result = simulation(firstSeed + i).build().runOnThisThread();
      simulatedS += Time.seconds(result.endNs());
      events += result.events();
      bad += result.spec().violations().isEmpty() ? 0 : 1;
      afterRun.accept(++done);
    }
    double cpuS = Time.seconds(Measurement.cpuNs() - startNs);
    long steps = 0;
    for (int i = 0; i < runs; i++) {
      steps += steps(firstSeed + i);
      afterRun.accept(++done);
    }
    return new Speed(runs, steps, events, simulatedS, cpuS, bad);
  }

  /** The number of steps of one run. */
  static long steps(long seed) {
    StepCounter counter = new StepCounter();
    simulation(seed).observer(counter).build().runOnThisThread();
    return counter.steps;
  }

  static Simulation.Builder simulation(long seed) {
    Demo demo = new IntersectionDemo();
    Request request = new Request(seed, OptionalInt.of(CARS), demo.defaults());
    SimSettings settings =
        demo.defaultSettings(request).set(Setting.CHAOS, demo.envelope()).build();
    return demo.plan(request, settings).simulation().name(demo.name()).seed(seed);
  }
}
