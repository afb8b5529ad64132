package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;

/**
 * Cuts a drawing into strokes. A part that two lines share belongs to the later one, as in a picture;
 * lines of one ink that meet end to end become one chain; a chain is cut so that each stroke's tube is
 * short and its ends are apart.
 */
public final class Strokes {

  /** A tube's limit, less some for long legs, which are cut. */
  private static final int MAX_LEGS = 24;

  /** Shorter strokes can be neither seen nor painted. */
  private static final double MIN_MM = 2;

  private final double sameMm;
  private final double longestMm;

  private Strokes(double sameMm, double longestMm) {
    this.sameMm = sameMm;
    this.longestMm = longestMm;
  }

  /**
   * The strokes of a drawing, in order; equal drawings have equal strokes. Drawing and strokes are
   * nowhere farther from each other than {@code sameMm} + 3 mm.
   *
   * @param lines in the order in which they are drawn
   * @param sameMm lines that run nearer to each other than this share that part
   * @param longestMm maximum length of a stroke
   */
  public static List<Stroke> of(List<Line> lines, double sameMm, double longestMm) {
    if (!(sameMm > 0) || !(longestMm > MIN_MM)) {
      throw new IllegalArgumentException("strokes: " + sameMm + " mm, " + longestMm + " mm");
    }
    Strokes cutter = new Strokes(sameMm, longestMm);
    List<Stroke> strokes = new ArrayList<>();
    for (Line chain : Chains.of(Overlaps.cut(lines, sameMm), sameMm)) {
      cutter.cut(chain, strokes);
    }
    return strokes;
  }

  private void cut(Line chain, List<Stroke> strokes) {
    for (Polyline part : fewLegs(chain.path())) {
      double lengthMm = part.lengthMm();
      double nearMm = 2 * sameMm;
      boolean isClosed = lengthMm > nearMm && part.start().distanceMm(part.end()) <= nearMm;
      int pieces = (int) StrictMath.ceil(lengthMm / longestMm);
      pieces = Math.max(pieces, isClosed ? 2 : 1);
      for (int i = 0; i < pieces; i++) {
        Polyline piece = part.between(lengthMm * i / pieces, lengthMm * (i + 1) / pieces);
        if (piece.lengthMm() >= MIN_MM) {
          strokes.add(new Stroke(strokes.size(), piece, chain.ink()));
        }
      }
    }
  }

  private static List<Polyline> fewLegs(Polyline chain) {
    List<Polyline> parts = new ArrayList<>();
    List<Point> points = chain.points();
    for (int from = 0; from < chain.legs(); from += MAX_LEGS) {
      int to = Math.min(from + MAX_LEGS, chain.legs());
      parts.add(new Polyline(points.subList(from, to + 1)));
    }
    return parts;
  }
}
