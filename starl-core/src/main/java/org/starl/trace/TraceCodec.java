package org.starl.trace;

import java.util.Map;
import org.starl.geometry.Pose;
import org.starl.shape.Decimals;
import org.starl.shape.JsonWriter;
import org.starl.shape.Shape;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Intervention;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The lines of a trace: one JSON object each, without white space, keys in a fixed order, as {@code
 * docs/trace-format.md} lists them. Keys are the names of the record components. The line of an
 * event depends only on the event.
 */
public final class TraceCodec {

  private TraceCodec() {}

  /** The line of {@code event}, without line end. */
  public static String line(TraceEvent event) {
    JsonWriter out = new JsonWriter();
    append(out, event);
    return out.textFrom(0);
  }

  /**
   * {@code event} with the precision of the format: lengths to 0.001 mm, angles to 0.000001 rad,
   * rounded half away from zero. Equal events have equal lines, and events with equal lines are
   * equal after this.
   */
  public static TraceEvent rounded(TraceEvent event) {
    if (event instanceof Moved moved) {
      return new Moved(
          moved.timeNs(),
          moved.robot(),
          rounded(moved.pose()),
          Decimals.round(moved.linearMmPerS(), Decimals.MM),
          Decimals.round(moved.angularRadPerS(), Decimals.RAD));
    }
    if (event instanceof Joined joined) {
      return new Joined(
          joined.timeNs(),
          joined.robot(),
          rounded(joined.pose()),
          Decimals.round(joined.radiusMm(), Decimals.MM));
    }
    return event;
  }

  private static Pose rounded(Pose pose) {
    return new Pose(
        Decimals.round(pose.xMm(), Decimals.MM),
        Decimals.round(pose.yMm(), Decimals.MM),
        Decimals.round(pose.headingRad(), Decimals.RAD));
  }

  static void append(JsonWriter out, TraceHeader header) {
    out.ascii("{\"kind\":\"header\",\"format\":");
    out.number(TraceHeader.FORMAT);
    text(out, ",\"starl\":", header.starl());
    text(out, ",\"scenario\":", header.scenario());
    number(out, ",\"scenarioSeed\":", header.scenarioSeed());
    number(out, ",\"behaviourSeed\":", header.behaviourSeed());
    out.ascii(",\"settings\":{");
    String comma = "";
    for (Map.Entry<String, String> setting : header.settings().entrySet()) {
      out.ascii(comma);
      out.string(setting.getKey());
      text(out, ":", setting.getValue());
      comma = ",";
    }
    texts(out, "},\"robots\":[", header.robots());
    out.ascii('}');
  }

  static void append(JsonWriter out, TraceEnd end) {
    number(out, "{\"kind\":\"end\",\"timeNs\":", end.timeNs());
    number(out, ",\"events\":", end.events());
    if (!end.unfinished().isEmpty()) {
      texts(out, ",\"unfinished\":[", end.unfinished());
    }
    out.ascii('}');
  }

  static void append(JsonWriter out, TraceEvent event) {
    out.ascii("{\"kind\":\"");
    out.ascii(kind(event));
    number(out, "\",\"timeNs\":", event.timeNs());
    text(out, ",\"robot\":", event.robot().name());
    switch (event) {
      case Action action -> {
        text(out, ",\"source\":", action.source().name());
        text(out, ",\"fact\":{", action.shape().name());
        json(out, ":", action.shape(), action.fact());
        out.ascii('}');
      }
      case Variable variable -> {
        text(out, ",\"source\":", variable.source().name());
        text(out, ",\"name\":", variable.name());
        json(out, ",\"value\":", variable.variable().shape(), variable.value());
      }
      case Sent sent -> {
        text(out, ",\"to\":", sent.to());
        text(out, ",\"channel\":", sent.channel().name());
        number(out, ",\"seq\":", sent.seq());
        number(out, ",\"bytes\":", sent.bytes());
        json(out, ",\"message\":", sent.shape(), sent.message());
      }
      case Delivered delivered -> {
        text(out, ",\"from\":", delivered.from().name());
        text(out, ",\"channel\":", delivered.channel().name());
        number(out, ",\"seq\":", delivered.seq());
        json(out, ",\"message\":", delivered.shape(), delivered.message());
      }
      case Dropped dropped -> {
        text(out, ",\"from\":", dropped.from());
        text(out, ",\"why\":", dropped.why());
      }
      case Moved moved -> {
        pose(out, moved.pose());
        decimal(out, ",\"linearMmPerS\":", moved.linearMmPerS(), Decimals.MM);
        decimal(out, ",\"angularRadPerS\":", moved.angularRadPerS(), Decimals.RAD);
      }
      case Joined joined -> {
        pose(out, joined.pose());
        decimal(out, ",\"radiusMm\":", joined.radiusMm(), Decimals.MM);
      }
      case Left left -> {}
      case Fault fault -> {
        text(out, ",\"name\":", fault.name());
        text(out, ",\"effect\":", fault.effect());
        text(out, ",\"detail\":", fault.detail());
      }
      case Intervention intervention -> {
        number(out, ",\"step\":", intervention.step());
        text(out, ",\"name\":", intervention.name());
        text(out, ",\"detail\":", intervention.detail());
      }
    }
    out.ascii('}');
  }

  private static String kind(TraceEvent event) {
    return switch (event) {
      case Action action -> "action";
      case Variable variable -> "variable";
      case Sent sent -> "sent";
      case Delivered delivered -> "delivered";
      case Dropped dropped -> "dropped";
      case Moved moved -> "moved";
      case Joined joined -> "joined";
      case Left left -> "left";
      case Fault fault -> "fault";
      case Intervention intervention -> "intervention";
    };
  }

  private static void pose(JsonWriter out, Pose pose) {
    decimal(out, ",\"xMm\":", pose.xMm(), Decimals.MM);
    decimal(out, ",\"yMm\":", pose.yMm(), Decimals.MM);
    decimal(out, ",\"headingRad\":", pose.headingRad(), Decimals.RAD);
  }

  private static void decimal(JsonWriter out, String key, double value, int decimals) {
    out.ascii(key);
    Decimals.append(out, value, decimals);
  }

  private static void number(JsonWriter out, String key, long value) {
    out.ascii(key);
    out.number(value);
  }

  private static void text(JsonWriter out, String key, String value) {
    out.ascii(key);
    out.string(value);
  }

  @SuppressWarnings("unchecked") // an event has values of its shapes only
  private static <T> void json(JsonWriter out, String key, Shape<T> shape, Object value) {
    out.ascii(key);
    shape.writeJson((T) value, out);
  }

  private static void texts(JsonWriter out, String key, Iterable<?> values) {
    out.ascii(key);
    String comma = "";
    for (Object value : values) {
      text(out, comma, value.toString());
      comma = ",";
    }
    out.ascii(']');
  }
}
