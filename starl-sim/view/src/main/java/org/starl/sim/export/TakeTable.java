package org.starl.sim.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.spec.Bodies;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes true poses as Motive exports a take: CSV, format 1.23, a rigid body for each robot, 100 frames a second, metres,
 * quaternions. Y points up: our x is its X, our y its -Z. A robot that is not on the floor has empty cells.
 */
public final class TakeTable implements SimObserver, Closeable {

  private static final long FRAME_NS = Time.NS_PER_S / 100;
  private static final String AXES = ",X,Y,Z,W,X,Y,Z";

  private final Writer out;
  private final Bodies bodies = new Bodies();
  private List<RobotId> robots = List.of();
  private long frame;

  public TakeTable(OutputStream out) {
    this.out = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
  }

  @Override
  public void started(TraceHeader header) {
    robots = header.robots();
    String name = header.scenario() + "-" + header.scenarioSeed();
    line(
        "Format Version,1.23,Take Name,%s,Take Notes,,Capture Frame Rate,100.000000,Export Frame Rate,100.000000,Rotation Type,Quaternion,Length Units,Meters,Coordinate Space,Global"
            .formatted(name));
    line("");
    line("," + cells(robot -> ",Rigid Body".repeat(7)));
    line("," + cells(robot -> ("," + robot).repeat(7)));
    line("," + cells(robot -> ("," + (robots.indexOf(robot) + 1)).repeat(7)));
    line("," + cells(robot -> ",Rotation".repeat(4) + ",Position".repeat(3)));
    line("Frame,Time (Seconds)" + cells(robot -> AXES));
  }

  @Override
  public void observed(TraceEvent event) {
    // A frame has what happened up to its time.
    advance(event.timeNs() - 1);
    bodies.observe(event);
  }

  @Override
  public void finished(SimResult result) {
    advance(result.endNs());
  }

  private void advance(long timeNs) {
    for (; frame * FRAME_NS <= timeNs; frame++) {
      long atNs = frame * FRAME_NS;
      String time = "%d,%d.%06d".formatted(frame, frame / 100, frame % 100 * 10_000);
      line(time + cells(robot -> bodies.robots().contains(robot) ? cells(robot, atNs) : ",,,,,,,"));
    }
  }

  private String cells(RobotId robot, long atNs) {
    Pose at = bodies.poseAt(robot, atNs);
    return String.format(
        Locale.ROOT,
        ",0.000000,%.6f,0.000000,%.6f,%.6f,0.000000,%.6f",
        StrictMath.sin(at.headingRad() / 2),
        StrictMath.cos(at.headingRad() / 2),
        at.xMm() / 1000,
        0 - at.yMm() / 1000);
  }

  private String cells(Function<RobotId, String> ofRobot) {
    StringBuilder all = new StringBuilder();
    robots.forEach(robot -> all.append(ofRobot.apply(robot)));
    return all.toString();
  }

  private void line(String text) {
    try {
      out.write(text + "\n");
    } catch (IOException e) {
      throw new UncheckedIOException("the table cannot be written", e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
