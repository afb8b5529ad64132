package org.starl.sim.export;

import java.io.OutputStream;
import org.starl.geometry.Pose;
import org.starl.trace.TraceEvent;

/**
 * Writes true motion as a table: one row whenever a body joins, changes its speeds or leaves.
 * Between two rows of a robot its body moves with the constant speeds of the first.
 */
public final class PositionTable extends CsvTable {

  public PositionTable(OutputStream out) {
    super(out, "time_s", "robot", "event", "x_mm", "y_mm", "heading_rad", "mm_per_s", "rad_per_s");
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Joined joined -> row(event, "joined", joined.pose(), 0, 0);
      case TraceEvent.Moved moved ->
          row(event, "moved", moved.pose(), moved.linearMmPerS(), moved.angularRadPerS());
      case TraceEvent.Left left ->
          row(seconds(left.timeNs()), left.robot(), "left", "", "", "", "", "");
      default -> {
        // Not a change of motion.
      }
    }
  }

  private void row(TraceEvent event, String kind, Pose pose, double mmPerS, double radPerS) {
    row(
        seconds(event.timeNs()),
        event.robot(),
        kind,
        pose.xMm(),
        pose.yMm(),
        pose.headingRad(),
        mmPerS,
        radPerS);
  }
}
