package org.starl.sim.view.page;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.sim.check.RunArtifacts;
import org.starl.sim.record.Filmstrip;
import org.starl.sim.record.Layer;
import org.starl.sim.record.PictureRecorder;
import org.starl.sim.record.PictureTime;
import org.starl.sim.replay.TracePlayer;
import org.starl.spec.Monitors;
import org.starl.trace.TraceReader;

/**
 * Writes a picture of the first violation, or of the last event if there is none. Without the app's
 * layer, which a simulation does not know: robots, trails and obstacles.
 */
public final class TraceArtifacts implements RunArtifacts {

  private static final int WIDTH_PX = 1420;

  /** For the service loader. */
  public TraceArtifacts() {}

  @Override
  public List<Path> write(Path trace, SimulationPlan plan) throws IOException {
    PictureRecorder violation =
        new PictureRecorder(plan.obstacles(), Layer.NONE, new PictureTime.Violation());
    Filmstrip last = new Filmstrip(plan.obstacles(), Layer.NONE, List.of(Long.MAX_VALUE));
    show(trace, plan, List.of(violation, last));
    last.cut();
    Path picture = beside(trace, ".png");
    try (OutputStream out = Files.newOutputStream(picture)) {
      if (violation.hasPicture()) {
        violation.writePng(out);
      } else {
        last.frames().get(0).writePng(WIDTH_PX, out);
      }
    }
    return List.of(picture);
  }

  private static void show(Path trace, SimulationPlan plan, List<SimObserver> observers)
      throws IOException {
    try (TraceReader reader =
        new TraceReader(
            trace.toString(), new BufferedInputStream(Files.newInputStream(trace)))) {
      TracePlayer.show(
          trace.toString(), reader, Monitors.of(plan.monitors()).monitors(), observers);
    } catch (BadInput truncated) {
      // The observers have the events before the error.
      return;
    }
  }

  /** {@code out/seed-17.trace} with another ending. */
  private static Path beside(Path trace, String ending) {
    String name = String.valueOf(trace.getFileName());
    return trace.resolveSibling(name.replaceFirst("\\.trace$", "") + ending);
  }
}
