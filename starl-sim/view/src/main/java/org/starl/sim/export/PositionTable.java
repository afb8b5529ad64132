package org.starl.sim.export;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.starl.geometry.Pose;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes true motion as a table: one line whenever a body comes, changes its motion or goes. Between
 * two lines of a robot its body moves with the constant speeds of the first.
 */
public final class PositionTable implements SimObserver, Closeable {

  private final CsvFile file;

  public PositionTable(OutputStream out) {
    file = new CsvFile(out);
  }

  @Override
  public void started(TraceHeader header) {
    file.row("time_s", "robot", "event", "x_mm", "y_mm", "heading_rad", "mm_per_s", "rad_per_s");
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Joined joined -> row(event, "joined", joined.pose(), 0, 0);
      case TraceEvent.Moved moved ->
          row(event, "moved", moved.pose(), moved.linearMmPerS(), moved.angularRadPerS());
      case TraceEvent.Left left ->
          file.row(CsvFile.seconds(left.timeNs()), left.robot(), "left", "", "", "", "", "");
      default -> {
        // Moves nothing.
      }
    }
  }

  private void row(TraceEvent event, String kind, Pose pose, double mmPerS, double radPerS) {
    file.row(
        CsvFile.seconds(event.timeNs()),
        event.robot(),
        kind,
        pose.xMm(),
        pose.yMm(),
        pose.headingRad(),
        mmPerS,
        radPerS);
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
