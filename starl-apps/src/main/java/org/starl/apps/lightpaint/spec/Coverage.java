package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;

/** Which parts of the strokes are painted, each by which pass, measured along them. */
final class Coverage {

  private final List<Stroke> strokes;
  private final double toleranceMm;
  private final SortedMap<Integer, List<Part>> parts = new TreeMap<>();

  /** What a pass has painted of its stroke, in mm from the stroke's start. */
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

  /** The latest point of {@code pass} is painted. */
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

  /** How much of what {@code pass} has painted was painted already, by it or before it, in mm. */
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

  /** The longest part of a stroke that is not painted, in mm; less than the tolerance is nothing. */
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

  boolean isPainted(int stroke) {
    return parts.containsKey(stroke) && longestGapMm(stroke) <= toleranceMm;
  }

  /** The numbers of the strokes that are not painted, in order. */
  List<Integer> missing() {
    List<Integer> missing = new ArrayList<>();
    for (Stroke stroke : strokes) {
      if (!isPainted(stroke.number())) {
        missing.add(stroke.number());
      }
    }
    return missing;
  }
}
