package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;

/** Which parts of the strokes are painted, by which pass, measured along the strokes. */
final class Coverage {

  private final List<Stroke> strokes;
  private final double toleranceMm;
  private final SortedMap<Integer, List<Part>> parts = new TreeMap<>();

  /** The part of its stroke that a pass has painted, in mm from the stroke's start. */
  static final class Part {
    private final Pass pass;
    private double fromMm;
    private double toMm;
    private double atMm;

    Part(Pass pass, double atMm) {
      this.pass = pass;
      this.fromMm = atMm;
      this.toMm = atMm;
      this.atMm = atMm;
    }
  }

  Coverage(List<Stroke> strokes, double toleranceMm) {
    this.strokes = List.copyOf(strokes);
    this.toleranceMm = toleranceMm;
  }

  /** Adds the latest point of {@code pass}. */
  void add(Pass pass) {
    Polyline path = strokes.get(pass.stroke()).path();
    Point point = pass.points().get(pass.points().size() - 1);
    List<Part> all = parts.computeIfAbsent(pass.stroke(), stroke -> new ArrayList<>());
    Part part = all.isEmpty() ? null : all.get(all.size() - 1);
    if (part == null || part.pass != pass) {
      all.add(new Part(pass, path.nearestMm(point, 0, path.lengthMm())));
      return;
    }
    double reachMm = 2 * toleranceMm;
    part.atMm = path.nearestMm(point, part.atMm - reachMm, part.atMm + reachMm);
    part.fromMm = Math.min(part.fromMm, part.atMm);
    part.toMm = Math.max(part.toMm, part.atMm);
  }

  /** The longest part, in mm, that {@code pass} painted although it, or an earlier pass, had already. */
  double twiceMm(Pass pass) {
    List<Part> all = parts.getOrDefault(pass.stroke(), List.of());
    Part last = all.get(all.size() - 1);
    double twiceMm = Math.min(last.toMm - last.atMm, last.atMm - last.fromMm);
    for (Part part : all) {
      if (part != last) {
        double bothMm = Math.min(part.toMm, last.toMm) - Math.max(part.fromMm, last.fromMm);
        twiceMm = Math.max(twiceMm, bothMm);
      }
    }
    return twiceMm;
  }

  /** The longest unpainted part of a stroke, in mm. */
  double longestGapMm(int stroke) {
    List<Part> sorted = new ArrayList<>(parts.getOrDefault(stroke, List.of()));
    sorted.sort((a, b) -> Double.compare(a.fromMm, b.fromMm));
    double gapMm = 0;
    double toMm = 0;
    for (Part part : sorted) {
      gapMm = Math.max(gapMm, part.fromMm - toMm);
      toMm = Math.max(toMm, part.toMm);
    }
    return Math.max(gapMm, strokes.get(stroke).path().lengthMm() - toMm);
  }

  private boolean isPainted(int stroke) {
    return parts.containsKey(stroke) && longestGapMm(stroke) <= toleranceMm;
  }

  /** The numbers of the strokes with a gap longer than the tolerance, in order. */
  List<Integer> missing() {
    return strokes.stream().map(Stroke::number).filter(number -> !isPainted(number)).toList();
  }
}
