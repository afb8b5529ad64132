package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Leaves each place of a drawing to one line: where lines run along each other, the one that is
 * drawn last keeps the place. Lines that cross or meet at a corner keep theirs.
 */
final class Overlaps {

  /** What two lines have in common by crossing, or at a corner of 15 degrees or more, is shorter. */
  private static final double LEAST_WIDTHS = 4;

  /** Rests that stick out no farther than this are not worth a stroke of their own. */
  private static final double STUB_MM = 2;

  private final double sameMm;
  private final List<Segment> kept = new ArrayList<>();

  private Overlaps(double sameMm) {
    this.sameMm = sameMm;
  }

  static List<Line> cut(List<Line> lines, double sameMm) {
    Overlaps overlaps = new Overlaps(sameMm);
    List<List<Line>> backwards = new ArrayList<>();
    for (int i = lines.size() - 1; i >= 0; i--) {
      backwards.add(overlaps.rest(lines.get(i)));
    }
    Collections.reverse(backwards);
    List<Line> all = new ArrayList<>();
    backwards.forEach(all::addAll);
    return all;
  }

  /** What is left of a line, in pieces. */
  private List<Line> rest(Line line) {
    List<Line> pieces = new ArrayList<>();
    List<Point> piece = new ArrayList<>();
    for (int i = 0; i < line.path().legs(); i++) {
      Segment leg = line.path().leg(i);
      double lengthMm = leg.from().distanceMm(leg.to());
      double atMm = 0;
      for (Span taken : taken(leg, lengthMm)) {
        extend(piece, leg, lengthMm, atMm, taken.fromMm());
        finish(piece, line.ink(), pieces);
        atMm = taken.toMm();
      }
      extend(piece, leg, lengthMm, atMm, lengthMm);
    }
    finish(piece, line.ink(), pieces);
    return pieces;
  }

  private void extend(List<Point> piece, Segment leg, double lengthMm, double fromMm, double toMm) {
    Segment part = new Segment(whole(at(leg, lengthMm, fromMm)), whole(at(leg, lengthMm, toMm)));
    boolean isWhole = fromMm == 0 && toMm == lengthMm;
    if (part.from().equals(part.to()) || (!isWhole && isShown(part))) {
      return;
    }
    if (piece.isEmpty()) {
      piece.add(part.from());
    }
    piece.add(part.to());
    // Not the whole leg: what is left out here is no reason to leave it out elsewhere.
    kept.add(part);
  }

  private static Point whole(Point point) {
    return new Point(StrictMath.rint(point.xMm()), StrictMath.rint(point.yMm()));
  }

  /** Whether it is hardly longer than lines are wide, and beside lines that are kept. */
  private boolean isShown(Segment part) {
    Point middle = part.from().plus(part.to()).times(0.5);
    return part.from().distanceMm(part.to()) <= sameMm
        && isBesideOne(part.from(), middle)
        && isBesideOne(middle, part.to());
  }

  /** As distance from a segment is convex, all that lies between the two is no farther. */
  private boolean isBesideOne(Point from, Point to) {
    double nearMm = sameMm + STUB_MM;
    return kept.stream()
        .anyMatch(other -> other.distanceMm(from) <= nearMm && other.distanceMm(to) <= nearMm);
  }

  private static void finish(List<Point> piece, Ink ink, List<Line> pieces) {
    if (piece.size() > 1) {
      pieces.add(new Line(new Polyline(piece), ink));
    }
    piece.clear();
  }

  /** From one place of a leg to another, in mm from its start. */
  private record Span(double fromMm, double toMm) {}

  /** Where other lines run along {@code leg}: in order, none meeting the next. */
  private List<Span> taken(Segment leg, double lengthMm) {
    List<Span> near = new ArrayList<>();
    for (Segment other : kept) {
      Span span = near(leg, lengthMm, other);
      if (span != null) {
        near.add(span);
      }
    }
    near.sort((a, b) -> Double.compare(a.fromMm(), b.fromMm()));
    List<Span> merged = new ArrayList<>();
    for (Span span : near) {
      Span last = merged.isEmpty() ? null : merged.get(merged.size() - 1);
      if (last != null && span.fromMm() <= last.toMm()) {
        merged.set(merged.size() - 1, new Span(last.fromMm(), Math.max(last.toMm(), span.toMm())));
      } else {
        merged.add(span);
      }
    }
    double leastMm = Math.min(lengthMm, LEAST_WIDTHS * sameMm);
    merged.removeIf(span -> span.toMm() - span.fromMm() < leastMm);
    return merged;
  }

  /**
   * Where {@code leg} runs within the distance of {@code other}. Distance from a segment is a convex
   * function, so this is one span; its ends are found by halving.
   */
  private @Nullable Span near(Segment leg, double lengthMm, Segment other) {
    if (leg.distanceMm(other) > sameMm) {
      return null;
    }
    double insideMm = nearestMm(leg, lengthMm, other);
    double fromMm = border(leg, lengthMm, other, insideMm, 0);
    double toMm = border(leg, lengthMm, other, insideMm, lengthMm);
    return new Span(fromMm, toMm);
  }

  private static double nearestMm(Segment leg, double lengthMm, Segment other) {
    double low = 0;
    double high = lengthMm;
    for (int i = 0; i < 60; i++) {
      double a = low + (high - low) / 3;
      double b = high - (high - low) / 3;
      if (other.distanceMm(at(leg, lengthMm, a)) <= other.distanceMm(at(leg, lengthMm, b))) {
        high = b;
      } else {
        low = a;
      }
    }
    return low;
  }

  private double border(
      Segment leg, double lengthMm, Segment other, double insideMm, double endMm) {
    if (other.distanceMm(at(leg, lengthMm, endMm)) <= sameMm) {
      return endMm;
    }
    double in = insideMm;
    double out = endMm;
    for (int i = 0; i < 40; i++) {
      double middle = (in + out) / 2;
      if (other.distanceMm(at(leg, lengthMm, middle)) <= sameMm) {
        in = middle;
      } else {
        out = middle;
      }
    }
    return in;
  }

  private static Point at(Segment leg, double lengthMm, double mm) {
    return leg.from().plus(leg.to().minus(leg.from()).times(mm / lengthMm));
  }
}
