package org.starl.deployment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.input.BadInput;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * How the machines' clocks may stand to each other: a system of difference constraints. Dates are right
 * within an error; nothing is delivered before it was sent; clocks drift apart at a bounded rate. Two
 * processes on one machine have one clock. The shortest paths between the constraints give the widest
 * differences (Cormen et al., "Introduction to Algorithms", section on difference constraints).
 */
final class ClockBounds {

  private static final double PARTS = 1e-6;

  private final List<String> machines = new ArrayList<>();
  private final long[][] most;

  /**
   * @param dateErrorNs a machine's date is off by so much at most
   * @param driftPpm two clocks drift apart by so many parts in a million at most
   * @throws BadInput if the clocks cannot stand so
   */
  ClockBounds(List<RobotTrace> traces, long dateErrorNs, long driftPpm) {
    for (RobotTrace trace : traces) {
      if (!machines.contains(trace.machine())) {
        machines.add(trace.machine());
      }
    }
    most = new long[machines.size()][machines.size()];
    for (int a = 0; a < most.length; a++) {
      for (int b = 0; b < most.length; b++) {
        most[a][b] = a == b ? 0 : Long.MAX_VALUE / 4;
      }
    }
    long driftNs = (long) (longestNs(traces) * (driftPpm * PARTS));
    dates(traces, 2 * dateErrorNs + driftNs);
    messages(traces, driftNs);
    close();
    for (int a = 0; a < most.length; a++) {
      if (most[a][a] < 0) {
        throw new BadInput(
            "the clock of machine "
                + machines.get(a)
                + " contradicts the messages and the others' clocks; expected a larger --clock-error or"
                + " --drift");
      }
    }
  }

  /**
   * Ways in which the clocks may stand, each as the times on one axis at which the traces have their time 0: the
   * middle of what is possible first, then each machine as early and as late as it can be. With one
   * machine there is one way.
   */
  List<long[]> ways(List<RobotTrace> traces) {
    List<long[]> offsets = new ArrayList<>();
    long[] middle = new long[machines.size()];
    for (int a = 0; a < middle.length; a++) {
      middle[a] = (most[a][0] - most[0][a]) / 2;
    }
    offsets.add(middle);
    for (int k = 0; k < machines.size() && machines.size() > 1; k++) {
      long[] early = new long[machines.size()];
      long[] late = new long[machines.size()];
      for (int a = 0; a < machines.size(); a++) {
        // All others as late as they can be after k, then as early.
        early[a] = most[a][k];
        late[a] = -most[k][a];
      }
      offsets.add(early);
      offsets.add(late);
    }
    List<long[]> ways = new ArrayList<>();
    for (long[] offset : offsets) {
      ways.add(starts(traces, offset));
    }
    return ways;
  }

  /** The widest that any two clocks may differ from what the middle says, in ns. */
  long uncertaintyNs() {
    long widest = 0;
    for (int a = 0; a < most.length; a++) {
      for (int b = 0; b < most.length; b++) {
        widest = Math.max(widest, (most[a][b] + most[b][a]) / 2);
      }
    }
    return widest;
  }

  private long[] starts(List<RobotTrace> traces, long[] offset) {
    long first = Long.MAX_VALUE;
    for (RobotTrace trace : traces) {
      first = Math.min(first, offset[index(trace)] + trace.machineNs());
    }
    long[] starts = new long[traces.size()];
    for (int i = 0; i < starts.length; i++) {
      starts[i] = offset[index(traces.get(i))] + traces.get(i).machineNs() - first;
    }
    return starts;
  }

  private int index(RobotTrace trace) {
    return machines.indexOf(trace.machine());
  }

  private static long longestNs(List<RobotTrace> traces) {
    return traces.stream().mapToLong(RobotTrace::lastNs).max().orElse(0);
  }

  private void dates(List<RobotTrace> traces, long errorNs) {
    for (RobotTrace a : traces) {
      for (RobotTrace b : traces) {
        // At the same date both clocks show the same time of the axis, but for the error.
        atMost(a, b, (a.dateNs() - a.machineNs()) - (b.dateNs() - b.machineNs()) + errorNs);
      }
    }
  }

  private void messages(List<RobotTrace> traces, long driftNs) {
    Map<String, Map<String, Long>> firstSent = new TreeMap<>();
    Map<String, RobotTrace> senders = new TreeMap<>();
    for (RobotTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        if (event instanceof Sent sent) {
          String key = Causes.key(sent);
          senders.putIfAbsent(key + trace.machine(), trace);
          firstSent
              .computeIfAbsent(key, each -> new TreeMap<>())
              .merge(trace.machine(), trace.machineNs() + sent.timeNs(), Math::min);
        }
      }
    }
    for (RobotTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        Map<String, Long> sent =
            event instanceof Delivered delivered ? firstSent.get(Causes.key(delivered)) : null;
        // A robot that has moved to another machine leaves open from which it was sent.
        if (sent != null && sent.size() == 1) {
          Map.Entry<String, Long> only = sent.entrySet().iterator().next();
          RobotTrace sender = senders.get(Causes.key((Delivered) event) + only.getKey());
          if (sender != null && !only.getKey().equals(trace.machine())) {
            long latestNs = trace.machineNs() + event.timeNs();
            atMost(sender, trace, latestNs - only.getValue() + driftNs);
          }
        }
      }
    }
  }

  /** The offset of a's machine is above that of b's by so much at most. */
  private void atMost(RobotTrace a, RobotTrace b, long ns) {
    int from = index(a);
    int to = index(b);
    if (from != to) {
      most[from][to] = Math.min(most[from][to], ns);
    }
  }

  private void close() {
    for (int via = 0; via < most.length; via++) {
      for (int a = 0; a < most.length; a++) {
        for (int b = 0; b < most.length; b++) {
          most[a][b] = Math.min(most[a][b], most[a][via] + most[via][b]);
        }
      }
    }
  }
}
