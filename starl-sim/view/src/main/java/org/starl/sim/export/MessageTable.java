package org.starl.sim.export;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes messages as a table: one line when one is sent (to a robot, or {@code *} for all in reach),
 * delivered or dropped. Its text is the message, or why it was dropped. {@code from} and {@code seq}
 * tell which it is; what is dropped has no {@code channel}, {@code seq} or {@code bytes}.
 */
public final class MessageTable implements SimObserver, Closeable {

  private final CsvFile file;

  public MessageTable(OutputStream out) {
    file = new CsvFile(out);
  }

  @Override
  public void started(TraceHeader header) {
    file.row("time_s", "event", "from", "to", "channel", "seq", "bytes", "text");
  }

  @Override
  public void observed(TraceEvent event) {
    double atS = CsvFile.seconds(event.timeNs());
    switch (event) {
      case TraceEvent.Sent sent ->
          file.row(
              atS,
              "sent",
              sent.robot(),
              sent.to(),
              sent.channel(),
              sent.seq(),
              sent.bytes(),
              sent.message());
      case TraceEvent.Delivered got ->
          file.row(
              atS,
              "delivered",
              got.from(),
              got.robot(),
              got.channel(),
              got.seq(),
              "",
              got.message());
      case TraceEvent.Dropped dropped ->
          file.row(atS, "dropped", dropped.from(), dropped.robot(), "", "", "", dropped.why());
      default -> {
        // No message.
      }
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
