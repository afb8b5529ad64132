package org.starl.sim.replay;

import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.shape.JsonWriter;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * Saves memory: equal values in events share one object, such as a message at each of its receivers.
 * Estimates the memory that the events take.
 */
final class EventInterner {

  private static final int MOST_VALUES = 1 << 13;
  private static final int EVENT_BYTES = 56;
  private static final int MOTION_BYTES = 96;

  // Of a value's objects, and for each character of its JSON text: numbers take less, sets up to
  // twice as much.
  private static final int VALUE_BYTES = 32;
  private static final int CHARACTER_BYTES = 5;

  // Cleared when it is full; frequent values return soon.
  private final Map<Object, Object> values = new LinkedHashMap<>();
  private final JsonWriter json = new JsonWriter();
  private long bytes;

  /** Estimated memory of all events so far. */
  long bytes() {
    return bytes;
  }

  /** An equal event with shared values. */
  TraceEvent intern(TraceEvent event) {
    bytes += EVENT_BYTES;
    return switch (event) {
      case Action e ->
          new Action(e.timeNs(), e.robot(), e.source(), e.shape(), one(e.shape(), e.fact()));
      case Variable e ->
          new Variable(
              e.timeNs(),
              e.robot(),
              e.source(),
              e.variable(),
              one(e.variable().shape(), e.value()));
      case Sent e ->
          new Sent(
              e.timeNs(),
              e.robot(),
              one(e.to()),
              e.channel(),
              e.seq(),
              e.bytes(),
              e.shape(),
              one(e.shape(), e.message()));
      case Delivered e ->
          new Delivered(
              e.timeNs(),
              e.robot(),
              e.from(),
              e.channel(),
              e.seq(),
              e.shape(),
              one(e.shape(), e.message()));
      case Dropped e -> new Dropped(e.timeNs(), e.robot(), one(e.from()), one(e.why()));
      case TraceEvent.Moved e -> {
        bytes += MOTION_BYTES - EVENT_BYTES;
        yield e;
      }
      default -> event;
    };
  }

  private String one(String text) {
    return (String) one(Shapes.TEXT, text);
  }

  @SuppressWarnings("unchecked") // an event has values of its shapes only
  private <T> Object one(Shape<T> shape, Object value) {
    Object known = values.putIfAbsent(value, value);
    if (known != null) {
      return known;
    }
    json.clear();
    shape.writeJson((T) value, json);
    bytes += VALUE_BYTES + (long) CHARACTER_BYTES * json.length();
    if (values.size() > MOST_VALUES) {
      values.clear();
    }
    return value;
  }
}
