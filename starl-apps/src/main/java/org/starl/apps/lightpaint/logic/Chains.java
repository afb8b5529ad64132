package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/** Joins lines of one ink that meet end to end. */
final class Chains {

  /** Points are dropped where the chain runs straight on, within this. */
  private static final double STRAIGHT_MM = 1;

  private Chains() {}

  /**
   * @param sameMm ends that are no farther apart than this meet
   */
  static List<Line> of(List<Line> lines, double sameMm) {
    List<Line> chains = new ArrayList<>();
    for (Line line : lines) {
      Line chain = line;
      for (int i = chains.size() - 1; i >= 0; i--) {
        Line joined = join(chains.get(i), chain, sameMm);
        if (joined != null) {
          chains.remove(i);
          chain = joined;
        }
      }
      chains.add(chain);
    }
    // Once, at the end: simplified at each joint, a long arc of short lines would become one chord.
    List<Line> simple = new ArrayList<>();
    for (Line chain : chains) {
      List<Point> points = Polyline.simplified(chain.path().points(), STRAIGHT_MM);
      if (points.size() > 1) {
        simple.add(new Line(new Polyline(points), chain.ink()));
      }
    }
    return simple;
  }

  private static @Nullable Line join(Line a, Line b, double sameMm) {
    if (!a.ink().equals(b.ink()) || isClosed(a.path(), sameMm) || isClosed(b.path(), sameMm)) {
      return null;
    }
    for (Polyline first : List.of(a.path(), a.path().reversed())) {
      for (Polyline second : List.of(b.path(), b.path().reversed())) {
        if (first.end().distanceMm(second.start()) <= sameMm) {
          List<Point> points = new ArrayList<>(first.points());
          points.addAll(second.points());
          return new Line(new Polyline(Polyline.withoutRepeats(points)), a.ink());
        }
      }
    }
    return null;
  }

  private static boolean isClosed(Polyline path, double sameMm) {
    return path.start().distanceMm(path.end()) <= sameMm;
  }
}
