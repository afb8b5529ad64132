package org.starl.sim.export;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.record.Layer;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes a run as an MCAP file, with the messages of {@link FoxgloveRecorder}, or with those of ROS 2
 * ({@link RosBag}). Its metadata {@code starl} has the app, the seeds and every setting.
 */
public final class McapRecorder implements SimObserver, Closeable {

  private final OutputStream out;
  private final Obstacles obstacles;
  private final Layer layer;
  private final boolean isRos;
  private @Nullable McapWriter writer;
  private @Nullable RosBag bag;
  private @Nullable FoxgloveRecorder recorder;

  /**
   * @param out closed by {@link #close}
   * @param obstacles of the world, hidden ones included
   * @param layer of the app; has observed no event, and is used by nothing else
   * @param isRos whether the messages are ROS 2's
   */
  public McapRecorder(OutputStream out, Obstacles obstacles, Layer layer, boolean isRos) {
    this.isRos = isRos;
    this.out = out;
    this.obstacles = obstacles;
    this.layer = layer;
  }

  @Override
  public void started(TraceHeader header) {
    McapWriter begun = new McapWriter(out, "StarL " + header.starl(), isRos);
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("app", header.scenario());
    facts.put("seed", Long.toString(header.scenarioSeed()));
    facts.put("behaviourSeed", Long.toString(header.behaviourSeed()));
    facts.putAll(header.settings());
    begun.metadata("starl", facts);
    writer = begun;
    bag = isRos ? new RosBag(begun) : null;
    recorder = new FoxgloveRecorder(obstacles, layer, bag == null ? begun : bag);
    recorder.started(header);
  }

  private FoxgloveRecorder recorder() {
    return Objects.requireNonNull(recorder, "an event before the start");
  }

  @Override
  public void observed(TraceEvent event) {
    recorder().observed(event);
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    recorder().violated(violation);
  }

  @Override
  public void wentWrong(Failure failure) {
    recorder().wentWrong(failure);
  }

  @Override
  public void logged(long timeNs, RobotId robot, Level level, String tag, String line) {
    recorder().logged(timeNs, robot, level, tag, line);
  }

  @Override
  public void finished(SimResult result) {
    recorder().finished(result);
  }

  /** The file {@code metadata.yaml} of a bag with {@code dataFile}; call it after the run. */
  public String metadata(String dataFile) {
    return Objects.requireNonNull(bag, "no bag of ROS 2").metadata(dataFile);
  }

  /**
   * Writes buffered data and the summary.
   *
   * @throws IOException if the data cannot be written
   */
  @Override
  public void close() throws IOException {
    if (writer == null) {
      out.close();
    } else {
      writer.close();
    }
  }
}
