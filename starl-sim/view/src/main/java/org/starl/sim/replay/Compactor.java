package org.starl.sim.replay;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * Replaces equal texts in events by one object: repeated names, and the text of a message, of which
 * each receiver has its own copy. Counts the approximate memory of the events.
 */
final class Compactor {

  private static final int MOST_TEXTS = 1 << 13;
  private static final int TEXT_BYTES = 48;
  private static final int EVENT_BYTES = 56;
  private static final int MOTION_BYTES = 96;
  private static final int LIST_BYTES = 48;

  // When the table is full, it is cleared: current strings are added again soon.
  private final Map<String, String> texts = new LinkedHashMap<>();
  private long bytes;

  /** About how many bytes all have taken so far. */
  long bytes() {
    return bytes;
  }

  /** An equal event. */
  TraceEvent compact(TraceEvent event) {
    bytes += EVENT_BYTES;
    return switch (event) {
      case Action e ->
          new Action(e.timeNs(), e.robot(), one(e.source()), one(e.name()), all(e.args()));
      case Variable e ->
          new Variable(e.timeNs(), e.robot(), one(e.source()), one(e.name()), one(e.value()));
      case Sent e ->
          new Sent(
              e.timeNs(),
              e.robot(),
              one(e.to()),
              one(e.channel()),
              e.seq(),
              e.bytes(),
              one(e.message()));
      case Delivered e ->
          new Delivered(
              e.timeNs(), e.robot(), e.from(), one(e.channel()), e.seq(), one(e.message()));
      case Dropped e -> new Dropped(e.timeNs(), e.robot(), one(e.from()), one(e.why()));
      case TraceEvent.Moved e -> {
        bytes += MOTION_BYTES - EVENT_BYTES;
        yield e;
      }
      default -> event;
    };
  }

  private List<String> all(List<String> several) {
    bytes += several.isEmpty() ? 0 : LIST_BYTES;
    return several.stream().map(this::one).toList();
  }

  private String one(String text) {
    String known = texts.putIfAbsent(text, text);
    if (known != null) {
      return known;
    }
    bytes += TEXT_BYTES + text.length();
    if (texts.size() > MOST_TEXTS) {
      texts.clear();
    }
    return text;
  }
}
