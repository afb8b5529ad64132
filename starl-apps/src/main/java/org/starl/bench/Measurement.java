package org.starl.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.sim.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;

/**
 * One run of a workload, in numbers. CPU time is that of the thread which ran the simulation: with
 * virtual threads that is everything; robots on platform threads are not counted in, so their
 * figures rest on wall time.
 *
 * @param coldness 0 for the first run in its JVM
 * @param bytesPerRobot of heap, in the middle of a run of its own after the timed ones
 */
public record Measurement(
    String workload,
    int robots,
    Workload.Style style,
    int coldness,
    long events,
    double simulatedS,
    double cpuS,
    double wallS,
    long bytesPerRobot,
    double peakRssMb) {

  private static final double NS_PER_S = 1e9;
  private static final double KB_PER_MB = 1024;

  /**
   * Runs {@code workload} {@code runs} times in this JVM, the first one cold.
   *
   * @throws BadInput if it cannot be run so
   */
  public static List<Measurement> take(
      Workload workload, int robots, Workload.Style style, int runs, long seed) {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    List<Measurement> taken = new ArrayList<>();
    for (int i = 0; i < runs; i++) {
      Simulation simulation = workload.plan(robots, style, seed).build();
      long cpuNs = threads.getCurrentThreadCpuTime();
      long wallNs = System.nanoTime();
      SimResult result = simulation.run();
      taken.add(
          new Measurement(
              workload.name(),
              robots,
              style,
              i,
              result.events(),
              result.endNs() / NS_PER_S,
              (threads.getCurrentThreadCpuTime() - cpuNs) / NS_PER_S,
              (System.nanoTime() - wallNs) / NS_PER_S,
              0,
              readPeakRssMb()));
    }
    long bytesPerRobot = Footprint.bytesPerRobot(workload, robots, style, seed);
    taken.replaceAll(measurement -> measurement.withBytesPerRobot(bytesPerRobot));
    return taken;
  }

  private Measurement withBytesPerRobot(long bytes) {
    return new Measurement(
        workload, robots, style, coldness, events, simulatedS, cpuS, wallS, bytes, peakRssMb);
  }

  /** Events a CPU second. */
  public double eventsPerCpuS() {
    return events / cpuS;
  }

  /** Simulated seconds a CPU second. */
  public double realTimeFactor() {
    return simulatedS / cpuS;
  }

  /** In the order in which to show it. */
  public Map<String, Object> asMap() {
    Map<String, Object> map = new LinkedHashMap<>();
    map.put("workload", workload);
    map.put("n", robots);
    map.put("style", style.name().toLowerCase(java.util.Locale.ROOT));
    map.put("run", coldness);
    map.put("events", events);
    map.put("ev_per_cpu_s", Math.round(eventsPerCpuS()));
    map.put("rtf", Math.round(realTimeFactor() * 100) / 100.0);
    map.put("cpu_s", Math.round(cpuS * 1000) / 1000.0);
    map.put("wall_s", Math.round(wallS * 1000) / 1000.0);
    map.put("bytes_per_robot", bytesPerRobot);
    map.put("peak_rss_mb", Math.round(peakRssMb * 10) / 10.0);
    map.put("jvm", Runtime.version().toString());
    return map;
  }

  /** As the kernel of the machine counts it; -1 where it does not say. */
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
