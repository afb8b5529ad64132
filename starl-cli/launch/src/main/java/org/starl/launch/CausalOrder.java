package org.starl.launch;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * Puts the events of several processes in one order: by time, but no event before its cause
 * (Lamport, "Time, clocks, and the ordering of events in a distributed system", 1978). The causes
 * of an event are the earlier events of its process and, for a delivery, the sending. Where a time
 * contradicts this, that event and the later ones of its process get a later time.
 */
final class CausalOrder {

  /** Names a message in the traces of its sender and its receivers. */
  record Message(RobotId from, long seq, Instance channel, Object message) {

    static Message of(Sent sent) {
      return new Message(sent.robot(), sent.seq(), sent.channel(), sent.message());
    }

    static Message of(Delivered delivered) {
      return new Message(
          delivered.from(), delivered.seq(), delivered.channel(), delivered.message());
    }
  }

  /** The events of one process and the position in them. */
  private static final class Cursor {
    private final List<TraceEvent> events;
    private final long startNs;
    private int next;
    private long lastNs = Long.MIN_VALUE;

    Cursor(List<TraceEvent> events, long startNs) {
      this.events = events;
      this.startNs = startNs;
    }

    TraceEvent head() {
      return events.get(next);
    }
  }

  private final List<Cursor> processes = new ArrayList<>();
  private final Set<Message> toBeSent = new LinkedHashSet<>();
  private final Map<Message, Long> sentNs = new LinkedHashMap<>();

  /** Adds the events of one process, whose time 0 is {@code startNs} of the merged trace. */
  void add(List<TraceEvent> events, long startNs) {
    processes.add(new Cursor(events, startNs));
    for (TraceEvent event : events) {
      if (event instanceof Sent sent) {
        toBeSent.add(Message.of(sent));
      }
    }
  }

  /** All events in order. Call once. */
  List<TraceEvent> inOrder() {
    List<TraceEvent> ordered = new ArrayList<>();
    for (Cursor process = next(); process != null; process = next()) {
      long atNs = timeNs(process);
      TraceEvent event = process.head();
      process.next++;
      process.lastNs = atNs;
      ordered.add(event.at(atNs));
      if (event instanceof Sent sent) {
        sentNs.putIfAbsent(Message.of(sent), atNs);
      }
    }
    return ordered;
  }

  /** The process with the next event; null at the end. */
  private @Nullable Cursor next() {
    Cursor first = null;
    Cursor blocked = null;
    for (Cursor process : processes) {
      if (process.next == process.events.size()) {
        continue;
      }
      if (isBlocked(process)) {
        blocked = blocked == null || timeNs(process) < timeNs(blocked) ? process : blocked;
      } else if (first == null || timeNs(process) < timeNs(first)) {
        first = process;
      }
    }
    // Two starts of a program may use the same sequence numbers, which looks like a cycle. Then the
    // earliest event is next.
    return first == null ? blocked : first;
  }

  private boolean isBlocked(Cursor process) {
    if (!(process.head() instanceof Delivered delivered)) {
      return false;
    }
    Message message = Message.of(delivered);
    return toBeSent.contains(message) && !sentNs.containsKey(message);
  }

  private long timeNs(Cursor process) {
    TraceEvent event = process.head();
    long atNs = Math.max(process.startNs + event.timeNs(), process.lastNs);
    Long causeNs = event instanceof Delivered delivered ? sentNs.get(Message.of(delivered)) : null;
    return causeNs == null || atNs > causeNs ? atNs : causeNs + 1;
  }
}
