package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.Measures;
import org.starl.apps.Product;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintTrace;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.spec.LightTrail;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.apps.lightpaint.view.PaintedDrawing;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** How much each robot painted, and when the drawing was done. */
final class LightPaintStory implements Story {

  private static final double NS_PER_S = 1e9;
  private static final double MM_PER_M = 1e3;

  private final Painting painting;
  private final LightTrail trail = new LightTrail();
  private final SortedMap<RobotId, Painter> painters = new TreeMap<>();
  private long lastLightNs;

  private static final class Painter {
    private final SortedSet<Integer> strokes = new TreeSet<>();
    private double paintedMm;
    private int retreats;
    private int crashes;
    private long endNs = -1;

    /** How many strokes were unassigned when it ended. */
    private int left = -1;
  }

  LightPaintStory(Painting painting) {
    this.painting = painting;
  }

  @Override
  public void observed(TraceEvent event) {
    trail.observe(event);
    switch (event) {
      case TraceEvent.Joined joined -> painter(joined.robot());
      case Fault fault when fault.name().equals(Fault.CRASH) -> painter(fault.robot()).crashes++;
      case Variable variable when variable.source().equals(PaintTrace.SOURCE) -> changed(variable);
      default -> {
        // Not part of the story.
      }
    }
  }

  private void changed(Variable variable) {
    Painter painter = painter(variable.robot());
    if (variable.name().equals(PaintTrace.LIGHT)) {
      lastLightNs = variable.timeNs();
    } else if (variable.name().equals(PaintTrace.LOCATION)) {
      if (variable.value().equals(Location.RETREAT.name())) {
        painter.retreats++;
      } else if (variable.value().equals(Location.DONE.name())) {
        painter.endNs = variable.timeNs();
      }
    }
  }

  @Override
  public void finished(SimResult result) {
    for (Pass pass : trail.passes()) {
      Painter painter = painter(pass.robot());
      painter.strokes.add(pass.stroke());
      painter.paintedMm += pass.lengthMm();
    }
    result.results().forEach((robot, ended) -> painter(robot).left = (Integer) ended.get(1));
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    double paintedMm = 0;
    for (Map.Entry<RobotId, Painter> entry : painters.entrySet()) {
      lines.add(entry.getKey() + " " + line(entry.getValue()));
      paintedMm += entry.getValue().paintedMm;
    }
    double drawingMm =
        painting.strokes().stream().mapToDouble(stroke -> stroke.path().lengthMm()).sum();
    lines.add(
        "painted %s of a drawing of %s in %d strokes; the last light went off at %s"
            .formatted(
                metres(paintedMm),
                metres(drawingMm),
                painting.strokes().size(),
                seconds(lastLightNs)));
    return lines;
  }

  private static String line(Painter painter) {
    int strokes = painter.strokes.size();
    StringBuilder line = new StringBuilder("painted ");
    line.append(strokes == 1 ? "1 stroke" : strokes + " strokes");
    line.append(", ").append(metres(painter.paintedMm));
    if (painter.retreats > 0) {
      line.append(", gave way ").append(times(painter.retreats));
    }
    if (painter.crashes > 0) {
      line.append(", crashed ").append(times(painter.crashes));
    }
    line.append(painter.endNs < 0 ? ", has not ended" : ", ended at " + seconds(painter.endNs));
    if (painter.left > 0) {
      line.append(" and gave up with ").append(painter.left).append(" strokes left");
    }
    return line.toString();
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
    figures.put("painted_at_s", lastLightNs / NS_PER_S);
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
            painters.values().stream().map(painter -> painter.paintedMm / MM_PER_M).toList()));
  }

  private Painter painter(RobotId robot) {
    return painters.computeIfAbsent(robot, id -> new Painter());
  }

  private static String times(int count) {
    return count == 1 ? "once" : count + " times";
  }

  private static String metres(double mm) {
    return String.format(Locale.ROOT, "%.2f m", mm / MM_PER_M);
  }

  private static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", ns / NS_PER_S);
  }
}
