package org.starl.sim.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import org.starl.geometry.Pose;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes true motion as a table: one line whenever a body comes, changes its motion or goes. Between
 * two lines of a robot its body moves with the constant speeds of the first. No value needs quotes:
 * robots' names have none of the characters that do.
 */
public final class PositionTable implements SimObserver, Closeable {

  private static final String HEAD =
      "time_s,robot,event,x_mm,y_mm,heading_rad,mm_per_s,rad_per_s\n";
  private static final double NS_PER_S = 1e9;

  private final Writer out;

  public PositionTable(OutputStream out) {
    this.out = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
  }

  @Override
  public void started(TraceHeader header) {
    write(HEAD);
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Joined joined -> line(event, "joined", joined.pose(), 0, 0);
      case TraceEvent.Moved moved ->
          line(event, "moved", moved.pose(), moved.linearMmPerS(), moved.angularRadPerS());
      case TraceEvent.Left left -> write(begin(event) + "left,,,,,\n");
      default -> {
        // Moves nothing.
      }
    }
  }

  private void line(TraceEvent event, String kind, Pose pose, double mmPerS, double radPerS) {
    write(
        begin(event)
            + kind
            + ","
            + pose.xMm()
            + ","
            + pose.yMm()
            + ","
            + pose.headingRad()
            + ","
            + mmPerS
            + ","
            + radPerS
            + "\n");
  }

  private static String begin(TraceEvent event) {
    return event.timeNs() / NS_PER_S + "," + event.robot() + ",";
  }

  private void write(String text) {
    try {
      out.write(text);
    } catch (IOException e) {
      throw new UncheckedIOException("the table of positions cannot be written", e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
