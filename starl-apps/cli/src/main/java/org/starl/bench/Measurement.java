package org.starl.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import org.starl.input.BadInput;
import org.starl.sim.Director;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;

/**
 * One run of a workload, in numbers. CPU time is that of the thread that ran the simulation. With
 * virtual threads that is all of it; robots on platform threads are not included: use wall time for
 * them.
 *
 * @param setUpS wall time from the plan until all robots have started; not part of the other figures
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

  private static final double NS_PER_S = 1e9;
  private static final double KB_PER_MB = 1024;

  /**
   * Runs {@code workload} {@code runs} times in this JVM; the first run is cold.
   *
   * @param afterRun called with the number of runs so far, after each run and outside of the measured time
   * @throws BadInput if the workload cannot run with these arguments
   */
  public static List<Measurement> take(
      Workload workload,
      int robots,
      Workload.Style style,
      int runs,
      long seed,
      IntConsumer afterRun) {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    List<Measurement> taken = new ArrayList<>();
    for (int i = 0; i < runs; i++) {
      Start start = new Start();
      Simulation.Builder plan = workload.plan(robots, style, seed);
      long setUpNs = System.nanoTime();
      SimResult result = plan.director(start).build().run();
      taken.add(
          new Measurement(
              workload.name(),
              robots,
              style,
              i,
              result.events() - start.events,
              result.endNs() / NS_PER_S,
              (start.wallNs - setUpNs) / NS_PER_S,
              (threads.getCurrentThreadCpuTime() - start.cpuNs) / NS_PER_S,
              (System.nanoTime() - start.wallNs) / NS_PER_S,
              0,
              readPeakRssMb()));
      afterRun.accept(taken.size());
    }
    long bytesPerRobot = Footprint.bytesPerRobot(workload, robots, style, seed);
    taken.replaceAll(measurement -> measurement.withBytesPerRobot(bytesPerRobot));
    return taken;
  }

  private Measurement withBytesPerRobot(long bytes) {
    return new Measurement(
        workload,
        robots,
        style,
        coldness,
        events,
        simulatedS,
        setUpS,
        cpuS,
        wallS,
        bytes,
        peakRssMb);
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
    map.put("rtf", Math.round(realTimeFactor() * 100) / 100.0);
    map.put("set_up_s", Math.round(setUpS * 1000) / 1000.0);
    map.put("cpu_s", Math.round(cpuS * 1000) / 1000.0);
    map.put("wall_s", Math.round(wallS * 1000) / 1000.0);
    map.put("bytes_per_robot", bytesPerRobot);
    map.put("peak_rss_mb", Math.round(peakRssMb * 10) / 10.0);
    map.put("jvm", Runtime.version().toString());
    return map;
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
            cpuNs = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
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
