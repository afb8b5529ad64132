package org.starl.deployment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * Puts several traces' events in one order: that of their times, but nothing before its cause (Lamport,
 * "Time, clocks, and the ordering of events in a distributed system", 1978): what a process did before,
 * and the sending of what is delivered. Where a time says otherwise, it and its process's later ones are
 * moved on.
 */
final class Causes {

  private static final class Line {
    private final List<TraceEvent> events;
    private final long startNs;
    private int next;
    private long lastNs = Long.MIN_VALUE;

    Line(List<TraceEvent> events, long startNs) {
      this.events = events;
      this.startNs = startNs;
    }

    TraceEvent head() {
      return events.get(next);
    }
  }

  private final List<Line> lines = new ArrayList<>();
  private final Set<String> toBeSent = new TreeSet<>();
  private final Map<String, Long> sentNs = new TreeMap<>();

  /** What one process did, whose time 0 is at {@code startNs}. */
  void add(List<TraceEvent> events, long startNs) {
    lines.add(new Line(events, startNs));
    for (TraceEvent event : events) {
      if (event instanceof Sent sent) {
        toBeSent.add(key(sent));
      }
    }
  }

  /** All of it, in order. Once. */
  List<TraceEvent> inOrder() {
    List<TraceEvent> ordered = new ArrayList<>();
    for (Line line = first(); line != null; line = first()) {
      long atNs = timeNs(line);
      TraceEvent event = line.head();
      line.next++;
      line.lastNs = atNs;
      ordered.add(event.at(atNs));
      if (event instanceof Sent sent) {
        sentNs.putIfAbsent(key(sent), atNs);
      }
    }
    return ordered;
  }

  /** One that says what no other trace must come before; null at the end. */
  private @Nullable Line first() {
    Line first = null;
    Line blocked = null;
    for (Line line : lines) {
      if (line.next == line.events.size()) {
        continue;
      }
      if (isBlocked(line)) {
        blocked = blocked == null || timeNs(line) < timeNs(blocked) ? line : blocked;
      } else if (first == null || timeNs(line) < timeNs(first)) {
        first = line;
      }
    }
    // Numbers that two starts of a program share may look like a cycle: then time alone decides.
    return first == null ? blocked : first;
  }

  private boolean isBlocked(Line line) {
    if (!(line.head() instanceof Delivered delivered)) {
      return false;
    }
    String key = key(delivered);
    return toBeSent.contains(key) && !sentNs.containsKey(key);
  }

  private long timeNs(Line line) {
    TraceEvent event = line.head();
    long atNs = Math.max(line.startNs + event.timeNs(), line.lastNs);
    Long causeNs = event instanceof Delivered delivered ? sentNs.get(key(delivered)) : null;
    return causeNs == null || atNs > causeNs ? atNs : causeNs + 1;
  }

  static String key(Sent sent) {
    return sent.robot() + " " + sent.seq() + " " + sent.channel() + " " + sent.message();
  }

  static String key(Delivered delivered) {
    return delivered.from()
        + " "
        + delivered.seq()
        + " "
        + delivered.channel()
        + " "
        + delivered.message();
  }
}
