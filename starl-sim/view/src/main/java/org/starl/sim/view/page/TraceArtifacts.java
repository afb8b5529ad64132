package org.starl.sim.view.page;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.starl.input.BadInput;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.sim.check.RunArtifacts;
import org.starl.sim.record.Filmstrip;
import org.starl.sim.record.Layer;
import org.starl.sim.record.PictureRecorder;
import org.starl.sim.record.PictureTime;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TracePlayer;
import org.starl.sim.view.Window;
import org.starl.spec.Monitors;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

/**
 * Writes a page that plays the run, and a picture of the first violation, or of the last event if
 * there is none. They show robots, messages, trails and obstacles, but not the app's drawing, which
 * a simulation does not know.
 */
public final class TraceArtifacts implements RunArtifacts {

  private static final int WIDTH_PX = 1420;

  /** For the service loader. */
  public TraceArtifacts() {}

  @Override
  public List<Path> write(Path trace, Vocabulary vocabulary, SimulationPlan plan, String failure)
      throws IOException {
    PictureRecorder violation =
        new PictureRecorder(plan.obstacles(), Layer.NONE, new PictureTime.Violation());
    Filmstrip last = new Filmstrip(plan.obstacles(), Layer.NONE, List.of(Long.MAX_VALUE));
    Recording recording = new Recording(plan.obstacles(), Layer.NONE);
    show(trace, vocabulary, plan, failure, recording, List.of(violation, last, recording));
    last.cut();
    Path picture = beside(trace, ".png");
    try (OutputStream out = Files.newOutputStream(picture)) {
      if (violation.hasPicture()) {
        violation.writePng(out);
      } else {
        last.frames().get(0).writePng(WIDTH_PX, out);
      }
    }
    Path page = beside(trace, ".html");
    try (OutputStream out = Files.newOutputStream(page)) {
      new RunPage(recording).write(out);
    }
    return List.of(picture, page);
  }

  @Override
  public void show(
      Path trace, Vocabulary vocabulary, SimulationPlan plan, String failure, long atNs)
      throws IOException, InterruptedException {
    if (!Window.isPossible()) {
      throw new IOException("no display for a window: use a desktop session, or xvfb-run");
    }
    Recording recording = new Recording(plan.obstacles(), Layer.NONE);
    show(trace, vocabulary, plan, failure, recording, List.of(recording));
    Window.showAt(recording, atNs);
  }

  private static void show(
      Path trace,
      Vocabulary vocabulary,
      SimulationPlan plan,
      String failure,
      Recording recording,
      List<SimObserver> observers)
      throws IOException {
    try (TraceReader reader =
        new TraceReader(
            trace.toString(), new BufferedInputStream(Files.newInputStream(trace)), vocabulary)) {
      TracePlayer.show(
          trace.toString(),
          reader,
          Monitors.of(plan.monitors()).monitors(),
          observers,
          plan.commands());
    } catch (BadInput truncated) {
      // The observers have the events before the error that ended the run.
      recording.failed(failure);
      Failure known = recording.wentWrong();
      if (known != null) {
        observers.forEach(observer -> observer.wentWrong(known));
      }
    }
  }

  /** {@code out/seed-17.trace} with another ending. */
  private static Path beside(Path trace, String ending) {
    String name = String.valueOf(trace.getFileName());
    return trace.resolveSibling(name.replaceFirst("\\.trace$", "") + ending);
  }
}
