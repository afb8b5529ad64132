package org.starl.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import java.util.function.LongFunction;
import org.starl.input.BadInput;
import org.starl.sim.Director;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/**
 * One run of a workload, in numbers. CPU time is that of the thread that ran the simulation. With
 * virtual threads that is all of it; robots on platform threads are not included: use wall time for
 * them.
 *
 * @param setUpS wall time from the plan until all robots have started; not part of the other
 *     figures
 * @param coldness 0 for the first run in its JVM
 * @param bytesPerRobot of heap, measured in the middle of a separate run after the timed ones
 */
public record Measurement(
    String workload,
    int robots,
    Workload.Style style,
    int coldness,
    long events,
    double simulatedS,
    double setUpS,
    double cpuS,
    double wallS,
    long bytesPerRobot,
    double peakRssMb) {

  private static final double KB_PER_MB = 1024;

  /** All robots have started then, and no workload has ended. */
  private static final long HEAP_MEASURED_AT_NS = 5 * Time.NS_PER_S;

  /**
   * Runs {@code workload} {@code runs} times in this JVM; the first run is cold.
   *
   * @param afterRun called with the number of runs so far, after each run and outside of the
   *     measured time
   * @throws BadInput if the workload cannot run with these arguments
   */
  public static List<Measurement> take(
      Workload workload,
      int robots,
      Workload.Style style,
      int runs,
      long seed,
      IntConsumer afterRun) {
    // Each makes its measurement from the heap per robot, which is measured last.
    List<LongFunction<Measurement>> timed = new ArrayList<>();
    for (int i = 0; i < runs; i++) {
      int coldness = i;
      Start start = new Start();
      Simulation.Builder plan = workload.plan(robots, style, seed);
      long setUpNs = System.nanoTime();
      SimResult result = plan.director(start).build().runOnThisThread();
      double cpuS = Time.seconds(cpuNs() - start.cpuNs);
      double wallS = Time.seconds(System.nanoTime() - start.wallNs);
      double peakRssMb = readPeakRssMb();
      timed.add(bytesPerRobot ->
          new Measurement(
              workload.name(),
              robots,
              style,
              coldness,
              result.events() - start.events,
              Time.seconds(result.endNs()),
              Time.seconds(start.wallNs - setUpNs),
              cpuS,
              wallS,
              bytesPerRobot,
              peakRssMb));
      afterRun.accept(timed.size());
    }
    long bytesPerRobot = heapBytes(workload.plan(robots, style, seed)) / robots;
    return timed.stream().map(measurement -> measurement.apply(bytesPerRobot)).toList();
  }

  /** The heap of all robots, measured in a run of its own: it collects garbage during the run. */
  private static long heapBytes(Simulation.Builder plan) {
    long before = heldBytes();
    long[] during = {before};
    plan.director(control -> control.at(HEAP_MEASURED_AT_NS, () -> during[0] = heldBytes()))
        .build()
        .runOnThisThread();
    return Math.max(0, during[0] - before);
  }

  private static long heldBytes() {
    MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
    memory.gc();
    return memory.getHeapMemoryUsage().getUsed();
  }

  static long cpuNs() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  /** Events per CPU second. */
  public double eventsPerCpuS() {
    return events / cpuS;
  }

  /** Simulated seconds per CPU second. */
  public double realTimeFactor() {
    return simulatedS / cpuS;
  }

  /** The figures in display order. */
  public Map<String, Object> asMap() {
    Map<String, Object> map = new LinkedHashMap<>();
    map.put("workload", workload);
    map.put("n", robots);
    map.put("style", style.name().toLowerCase(Locale.ROOT));
    map.put("run", coldness);
    map.put("events", events);
    map.put("ev_per_cpu_s", Math.round(eventsPerCpuS()));
    map.put("rtf", rounded(realTimeFactor(), 100));
    map.put("set_up_s", rounded(setUpS, 1000));
    map.put("cpu_s", rounded(cpuS, 1000));
    map.put("wall_s", rounded(wallS, 1000));
    map.put("bytes_per_robot", bytesPerRobot);
    map.put("peak_rss_mb", rounded(peakRssMb, 10));
    map.put("jvm", Runtime.version().toString());
    return map;
  }

  private static double rounded(double value, double perUnit) {
    return Math.round(value * perUnit) / perUnit;
  }

  /** Reads the clocks when all robots have started, which they do at time 0. */
  private static final class Start implements Director {
    private long cpuNs;
    private long wallNs;
    private long events;

    @Override
    public void direct(SimControl control) {
      control.at(
          1,
          () -> {
            events = control.events();
            wallNs = System.nanoTime();
            cpuNs = Measurement.cpuNs();
          });
    }
  }

  /** Peak resident memory as the operating system counts it; -1 if unknown. */
  private static double readPeakRssMb() {
    Path status = Path.of("/proc/self/status");
    if (!Files.isReadable(status)) {
      return -1;
    }
    try {
      for (String line : Files.readAllLines(status)) {
        if (line.startsWith("VmHWM:")) {
          return Long.parseLong(line.replaceAll("[^0-9]", "")) / KB_PER_MB;
        }
      }
      return -1;
    } catch (IOException e) {
      throw new BadInput(status + ": " + e.getMessage());
    }
  }
}
