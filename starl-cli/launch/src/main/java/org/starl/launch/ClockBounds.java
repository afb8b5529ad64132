package org.starl.launch;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.input.BadInput;
import org.starl.launch.CausalOrder.Message;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * The possible offsets between the clocks of several machines, as a system of difference
 * constraints: dates are right within an error, no message arrives before it is sent, and clocks
 * drift apart at a bounded rate. Processes of one machine share its clock. Shortest paths over the
 * constraints give the largest differences (Cormen et al., "Introduction to Algorithms", section on
 * difference constraints).
 */
final class ClockBounds {

  private static final double PARTS = 1e-6;

  private final List<String> machines;
  // maxNs[a][b]: the offset of machine a exceeds that of machine b by at most this.
  private final long[][] maxNs;

  /**
   * @param dateErrorNs the largest error of a machine's date
   * @param driftPpm the largest drift between two clocks, in parts per million
   * @throws BadInput if no offsets satisfy all constraints
   */
  ClockBounds(List<RecordedTrace> traces, long dateErrorNs, long driftPpm) {
    machines = traces.stream().map(RecordedTrace::machine).distinct().toList();
    maxNs = new long[machines.size()][machines.size()];
    for (int a = 0; a < maxNs.length; a++) {
      Arrays.fill(maxNs[a], Long.MAX_VALUE / 4);
      maxNs[a][a] = 0;
    }
    long longestNs = traces.stream().mapToLong(RecordedTrace::lastNs).max().orElse(0);
    long driftNs = (long) (longestNs * (driftPpm * PARTS));
    addDates(traces, 2 * dateErrorNs + driftNs);
    addMessages(traces, driftNs);
    closeOverPaths();
    for (int a = 0; a < maxNs.length; a++) {
      if (maxNs[a][a] < 0) {
        throw new BadInput(
            "the clock of machine "
                + machines.get(a)
                + " contradicts the messages and the other clocks; expected a larger --clock-error"
                + " or --drift");
      }
    }
  }

  /**
   * Possible clock offsets, each as the start times of the traces on one axis: the middle first,
   * then for each machine the two extremes. There is only one for one machine.
   */
  List<long[]> candidates(List<RecordedTrace> traces) {
    int count = machines.size();
    List<long[]> candidates = new ArrayList<>();
    long[] offsets = new long[count];
    Arrays.setAll(offsets, a -> (maxNs[a][0] - maxNs[0][a]) / 2);
    candidates.add(starts(traces, offsets));
    for (int k = 0; k < count && count > 1; k++) {
      int machine = k;
      // Machine k as early as possible against all others, then as late as possible.
      Arrays.setAll(offsets, a -> maxNs[a][machine]);
      candidates.add(starts(traces, offsets));
      Arrays.setAll(offsets, a -> -maxNs[machine][a]);
      candidates.add(starts(traces, offsets));
    }
    return candidates;
  }

  /** The largest error of a difference between two clocks in the middle candidate, in ns. */
  long uncertaintyNs() {
    long widest = 0;
    for (int a = 0; a < maxNs.length; a++) {
      for (int b = 0; b < maxNs.length; b++) {
        widest = Math.max(widest, (maxNs[a][b] + maxNs[b][a]) / 2);
      }
    }
    return widest;
  }

  private long[] starts(List<RecordedTrace> traces, long[] offsets) {
    long[] starts =
        traces.stream()
            .mapToLong(trace -> offsets[machines.indexOf(trace.machine())] + trace.machineNs())
            .toArray();
    long firstNs = Arrays.stream(starts).min().orElse(0);
    return Arrays.stream(starts).map(startNs -> startNs - firstNs).toArray();
  }

  /** Equal dates mean equal times, within the error. */
  private void addDates(List<RecordedTrace> traces, long errorNs) {
    for (RecordedTrace a : traces) {
      for (RecordedTrace b : traces) {
        long differenceNs = (a.dateNs() - a.machineNs()) - (b.dateNs() - b.machineNs());
        constrain(a.machine(), b.machine(), differenceNs + errorNs);
      }
    }
  }

  private void addMessages(List<RecordedTrace> traces, long driftNs) {
    Map<Message, Map<String, Long>> firstSentNs = new LinkedHashMap<>();
    for (RecordedTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        if (event instanceof Sent sent) {
          firstSentNs
              .computeIfAbsent(Message.of(sent), each -> new TreeMap<>())
              .merge(trace.machine(), trace.machineNs() + sent.timeNs(), Math::min);
        }
      }
    }
    for (RecordedTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        Map<String, Long> sentNs =
            event instanceof Delivered delivered ? firstSentNs.get(Message.of(delivered)) : null;
        // Sent from two machines (a robot has moved): no constraint.
        if (sentNs != null && sentNs.size() == 1) {
          long deliveredNs = trace.machineNs() + event.timeNs();
          sentNs.forEach(
              (machine, atNs) -> constrain(machine, trace.machine(), deliveredNs - atNs + driftNs));
        }
      }
    }
  }

  /** The offset of machine {@code a} exceeds that of {@code b} by at most {@code ns}. */
  private void constrain(String a, String b, long ns) {
    if (!a.equals(b)) {
      long[] row = maxNs[machines.indexOf(a)];
      int to = machines.indexOf(b);
      row[to] = Math.min(row[to], ns);
    }
  }

  private void closeOverPaths() {
    for (int via = 0; via < maxNs.length; via++) {
      for (int a = 0; a < maxNs.length; a++) {
        for (int b = 0; b < maxNs.length; b++) {
          maxNs[a][b] = Math.min(maxNs[a][b], maxNs[a][via] + maxNs[via][b]);
        }
      }
    }
  }
}
