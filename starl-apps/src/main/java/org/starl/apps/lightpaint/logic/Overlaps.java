package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Gives each place of a drawing to one line: where lines run along each other, the line drawn last
 * keeps the place. Lines that cross, or meet at a corner, keep theirs.
 */
final class Overlaps {

  /** Two lines that cross, or meet at 15 degrees or more, share less than this many widths. */
  private static final double MIN_SHARED_WIDTHS = 4;

  /** A remainder that sticks out no farther than this gets no stroke of its own. */
  private static final double STUB_MM = 2;

  /** Legs are sampled at least this densely. */
  private static final double SAMPLE_MM = 0.5;

  private final double sameMm;
  private final List<Segment> kept = new ArrayList<>();

  private Overlaps(double sameMm) {
    this.sameMm = sameMm;
  }

  /** The parts of {@code lines} that no later line covers, in drawing order. */
  static List<Line> cut(List<Line> lines, double sameMm) {
    Overlaps overlaps = new Overlaps(sameMm);
    List<Line> parts = new ArrayList<>();
    for (int i = lines.size() - 1; i >= 0; i--) {
      parts.addAll(0, overlaps.uncovered(lines.get(i)));
    }
    return parts;
  }

  private List<Line> uncovered(Line line) {
    List<Line> parts = new ArrayList<>();
    List<Point> part = new ArrayList<>();
    for (int i = 0; i < line.path().legs(); i++) {
      Segment leg = line.path().leg(i);
      double from = 0;
      for (Span span : covered(leg)) {
        extend(part, leg, from, span.from());
        finish(part, line.ink(), parts);
        from = span.to();
      }
      extend(part, leg, from, 1);
    }
    finish(part, line.ink(), parts);
    return parts;
  }

  /** Adds the leg from one fraction of its length to another. */
  private void extend(List<Point> part, Segment leg, double from, double to) {
    Segment piece = new Segment(Polyline.rounded(at(leg, from)), Polyline.rounded(at(leg, to)));
    boolean isWholeLeg = from == 0 && to == 1;
    if (piece.from().equals(piece.to()) || (!isWholeLeg && isStub(piece))) {
      return;
    }
    if (part.isEmpty()) {
      part.add(piece.from());
    }
    part.add(piece.to());
    // Only the piece, not its leg: what this line leaves out must not remove parts of other lines.
    kept.add(piece);
  }

  /** Whether the piece is no longer than a line is wide, and beside lines that are kept. */
  private boolean isStub(Segment piece) {
    Point middle = at(piece, 0.5);
    return piece.from().distanceMm(piece.to()) <= sameMm
        && isBesideKept(piece.from(), middle)
        && isBesideKept(middle, piece.to());
  }

  /** Distance from a segment is convex, so all points between the two are no farther from it. */
  private boolean isBesideKept(Point from, Point to) {
    double nearMm = sameMm + STUB_MM;
    return kept.stream()
        .anyMatch(other -> other.distanceMm(from) <= nearMm && other.distanceMm(to) <= nearMm);
  }

  private static void finish(List<Point> part, Ink ink, List<Line> parts) {
    if (part.size() > 1) {
      parts.add(new Line(new Polyline(part), ink));
    }
    part.clear();
  }

  /** Part of a leg, from one fraction of its length to another. */
  private record Span(double from, double to) {}

  /** The spans of {@code leg} along which kept lines run, in order. */
  private List<Span> covered(Segment leg) {
    List<Segment> near = new ArrayList<>(kept);
    near.removeIf(other -> other.distanceMm(leg) > sameMm);
    List<Span> spans = new ArrayList<>();
    double lengthMm = leg.from().distanceMm(leg.to());
    double minShared = Math.min(1, MIN_SHARED_WIDTHS * sameMm / lengthMm);
    int samples = near.isEmpty() ? 0 : (int) StrictMath.ceil(lengthMm / SAMPLE_MM);
    int first = -1;
    for (int i = 0; i <= samples; i++) {
      Point place = at(leg, i / (double) samples);
      boolean isCovered = near.stream().anyMatch(other -> other.distanceMm(place) <= sameMm);
      if (isCovered && first < 0) {
        first = i;
      }
      int last = isCovered ? i : i - 1;
      if (first >= 0 && (!isCovered || i == samples)) {
        Span span = new Span(first / (double) samples, last / (double) samples);
        if (span.to() - span.from() >= minShared) {
          spans.add(span);
        }
        first = -1;
      }
    }
    return spans;
  }

  private static Point at(Segment leg, double fraction) {
    return leg.from().plus(leg.to().minus(leg.from()).times(fraction));
  }
}
