package org.starl.sim.export;

import java.io.OutputStream;
import org.starl.trace.TraceEvent;

/**
 * Writes messages as a table: one row per message that is sent (to a robot, or {@code *} for all
 * robots in range), delivered or dropped. The column {@code text} is the message, or the reason of
 * a drop. {@code from} and {@code seq} identify the message; a drop has no {@code channel}, {@code
 * seq} or {@code bytes}.
 */
public final class MessageTable extends CsvTable {

  public MessageTable(OutputStream out) {
    super(out, "time_s", "event", "from", "to", "channel", "seq", "bytes", "text");
  }

  @Override
  public void observed(TraceEvent event) {
    double atS = seconds(event.timeNs());
    switch (event) {
      case TraceEvent.Sent e ->
          row(atS, "sent", e.robot(), e.to(), e.channel(), e.seq(), e.bytes(), e.message());
      case TraceEvent.Delivered e ->
          row(atS, "delivered", e.from(), e.robot(), e.channel(), e.seq(), "", e.message());
      case TraceEvent.Dropped e -> row(atS, "dropped", e.from(), e.robot(), "", "", "", e.why());
      default -> {
        // Not a message.
      }
    }
  }
}
