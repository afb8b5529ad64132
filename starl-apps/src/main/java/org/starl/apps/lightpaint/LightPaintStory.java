package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Product;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.spec.LightTrail;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.apps.lightpaint.view.PaintedDrawing;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** How much each robot painted, and when the drawing was done. */
final class LightPaintStory implements Story {

  private final Painting painting;
  private final List<String> notes;
  private final LightTrail trail = new LightTrail();
  private final SortedMap<RobotId, Painter> painters = new TreeMap<>();
  private long lastLightNs;

  private static final class Painter {
    private int retreats;
    private int crashes;
    private long endNs = -1;

    /** How many strokes were unassigned when it ended. */
    private int left = -1;
  }

  /**
   * @param notes what of the drawing is not painted
   */
  LightPaintStory(Painting painting, List<String> notes) {
    this.painting = painting;
    this.notes = notes;
  }

  @Override
  public void observed(TraceEvent event) {
    trail.observe(event);
    switch (event) {
      case TraceEvent.Joined joined -> painter(joined.robot());
      case Fault fault when fault.name().equals(Fault.CRASH) -> painter(fault.robot()).crashes++;
      case Variable variable when variable.source().equals(Instance.APP) -> changed(variable);
      default -> {
        // Not part of the story.
      }
    }
  }

  private void changed(Variable variable) {
    Painter painter = painter(variable.robot());
    Location location = variable.of(PaintFact.LOCATION);
    if (variable.of(PaintFact.LIGHT) != null) {
      lastLightNs = variable.timeNs();
    } else if (location == Location.RETREAT) {
      painter.retreats++;
    } else if (location == Location.DONE) {
      painter.endNs = variable.timeNs();
    }
  }

  @Override
  public void finished(SimResult result) {
    result.results().forEach((robot, ended) -> painter(robot).left = (Integer) ended.get(1));
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    painters.forEach((robot, painter) -> lines.add(robot + " " + line(robot, painter)));
    double paintedMm = painters.keySet().stream().mapToDouble(trail::paintedMm).sum();
    double drawingMm =
        painting.strokes().stream().mapToDouble(stroke -> stroke.path().lengthMm()).sum();
    lines.add(
        String.format(
            Locale.ROOT,
            "painted %.2f m of a drawing of %.2f m in %d strokes;"
                + " the last light went off at %.1f s",
            paintedMm / 1e3,
            drawingMm / 1e3,
            painting.strokes().size(),
            Time.seconds(lastLightNs)));
    lines.addAll(notes);
    return lines;
  }

  private String line(RobotId robot, Painter painter) {
    long strokes =
        trail.passes().stream()
            .filter(pass -> pass.robot().equals(robot))
            .map(Pass::stroke)
            .distinct()
            .count();
    double metres = trail.paintedMm(robot) / 1e3;
    return String.format(
            Locale.ROOT, "painted %d stroke%s, %.2f m", strokes, strokes == 1 ? "" : "s", metres)
        + times(", gave way", painter.retreats)
        + times(", crashed", painter.crashes)
        + (painter.endNs < 0 ? ", has not ended" : ", ended at " + Time.text(painter.endNs, 1))
        + (painter.left > 0
            ? String.format(Locale.ROOT, " and gave up with %d strokes left", painter.left)
            : "");
  }

  private static String times(String event, int count) {
    return count == 0 ? "" : event + (count == 1 ? " once" : " " + count + " times");
  }

  @Override
  public List<Product> products() {
    return List.of(
        new Product(".svg", out -> paintedDrawing().writeSvg(out)),
        new Product(".png", out -> paintedDrawing().writePng(out)));
  }

  private PaintedDrawing paintedDrawing() {
    return new PaintedDrawing(painting.strokes(), trail.passes());
  }

  @Override
  public Measures measures() {
    List<Long> endsNs = new ArrayList<>();
    for (Painter painter : painters.values()) {
      if (painter.endNs >= 0 && painter.left == 0) {
        endsNs.add(painter.endNs);
      }
    }
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("painted_at_s", Time.seconds(lastLightNs));
    return new Measures(painters.size(), endsNs.size(), endsNs, figures);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("time until a painter had ended", measures().waitsNs()),
        new Sample(
            "painted by a robot",
            Sample.Kind.SIZES,
            "m",
            painters.keySet().stream().map(robot -> trail.paintedMm(robot) / 1e3).toList()));
  }

  private Painter painter(RobotId robot) {
    return painters.computeIfAbsent(robot, id -> new Painter());
  }
}
