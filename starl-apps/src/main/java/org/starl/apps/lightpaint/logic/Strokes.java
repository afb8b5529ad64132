package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Cuts a drawing into strokes. Where lines run along each other, the line drawn last keeps the
 * place, as in a picture; lines that cross, or meet at a corner, keep theirs. Lines of one ink that
 * meet end to end become one chain. A chain is cut so that each stroke's tube is short and its ends
 * are apart.
 */
public final class Strokes {

  /** Maximum number of a painting's strokes. */
  public static final int MAX = 300;

  /**
   * Two lines that meet at 15 degrees or more, or cross at 30, share less than this many widths.
   */
  private static final double MIN_SHARED_WIDTHS = 4;

  /** Legs are sampled at least this densely. */
  private static final double SAMPLE_MM = 0.5;

  /** Points are dropped where a chain runs straight on, within this. */
  private static final double STRAIGHT_MM = 1;

  /** A tube's limit, less some for long legs, which are cut. */
  private static final int MAX_LEGS = 24;

  /** Of a line that is covered, what is shorter is left out as well. */
  private static final double MIN_MM = 2;

  /** A line runs along an earlier part of itself if the way from there is longer than this. */
  private static final double MIN_DETOUR = 4;

  /**
   * @param isCorner whether a leg begins there
   */
  private record Place(Point point, double alongMm, boolean isCorner) {}

  /**
   * A leg of a line that keeps its place.
   *
   * @param fromMm where it begins along the line that is cut; minus infinity if it is of another
   */
  private record Kept(Segment leg, double fromMm) {

    boolean covers(Place place, double sameMm) {
      Point nearest = leg.nearest(place.point());
      double awayMm = nearest.distanceMm(place.point());
      double wayMm = place.alongMm() - fromMm - leg.from().distanceMm(nearest);
      return awayMm <= sameMm && wayMm > MIN_DETOUR * awayMm;
    }
  }

  private final double sameMm;
  private final double mostMm;
  private double keptMm;
  private final List<Kept> kept = new ArrayList<>();
  private final List<Line> chains = new ArrayList<>();
  private final List<Stroke> strokes = new ArrayList<>();

  private Strokes(double sameMm, double longestMm) {
    this.sameMm = sameMm;
    mostMm = MAX * longestMm;
  }

  /**
   * The strokes of a drawing, in order; equal drawings have equal strokes. Drawing and strokes are
   * nowhere farther from each other than {@code sameMm} + 3 mm. None, early, if the drawing is longer
   * than {@link #MAX} strokes.
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
    List<Line> parts = new ArrayList<>();
    for (int i = lines.size() - 1; i >= 0; i--) {
      parts.addAll(0, cutter.uncovered(lines.get(i)));
    }
    if (cutter.keptMm > cutter.mostMm) {
      return List.of();
    }
    parts.forEach(cutter::chain);
    cutter.chains.forEach(chain -> cutter.cut(chain, longestMm));
    return cutter.strokes;
  }

  /** The parts of {@code line} along which no kept line runs. They are kept, too. */
  private List<Line> uncovered(Line line) {
    List<Place> places = new ArrayList<>();
    BitSet covered = new BitSet();
    List<Kept> all = new ArrayList<>(kept);
    double alongMm = 0;
    for (Segment leg : line.path().legs()) {
      if (keptMm > mostMm) {
        return List.of();
      }
      List<Kept> near = new ArrayList<>(all);
      near.removeIf(other -> other.leg().distanceMm(leg) > sameMm);
      int first = places.size();
      double legMm = leg.from().distanceMm(leg.to());
      int samples = (int) StrictMath.ceil(legMm / SAMPLE_MM);
      for (int i = 0; i <= samples; i++) {
        Point point = leg.from().plus(leg.to().minus(leg.from()).times(i / (double) samples));
        Place place = new Place(point, alongMm + legMm * i / samples, i == 0);
        covered.set(places.size(), near.stream().anyMatch(other -> other.covers(place, sameMm)));
        places.add(place);
      }
      // Only the piece, not its leg: what this line leaves out must not remove parts of others.
      for (List<Place> piece : uncovered(places, covered, first)) {
        Place start = piece.get(0);
        Point end = piece.get(piece.size() - 1).point();
        all.add(new Kept(new Segment(start.point(), end), start.alongMm()));
        keptMm += start.point().distanceMm(end);
      }
      alongMm += legMm;
    }
    keepCrossings(places, covered);
    List<Line> parts = new ArrayList<>();
    for (List<Place> piece : uncovered(places, covered, 0)) {
      List<Point> points = piece.size() < places.size() ? rounded(piece) : line.path().points();
      if (points.size() > 1) {
        parts.add(new Line(new Polyline(points), line.ink()));
      }
    }
    parts.stream()
        .flatMap(part -> part.path().legs().stream())
        .forEach(leg -> kept.add(new Kept(leg, Double.NEGATIVE_INFINITY)));
    return parts;
  }

  /** The runs of places from number {@code first} on that are not covered. */
  private static List<List<Place>> uncovered(List<Place> places, BitSet covered, int first) {
    List<List<Place>> pieces = new ArrayList<>();
    int to;
    for (int from = covered.nextClearBit(first);
        from < places.size() - 1;
        from = covered.nextClearBit(to)) {
      to = covered.nextSetBit(from);
      to = to < 0 ? places.size() - 1 : to;
      pieces.add(places.subList(from, to + 1));
    }
    return pieces;
  }

  /** A line that is covered only for a short way, but not wholly, keeps its place. */
  private void keepCrossings(List<Place> places, BitSet covered) {
    int to;
    for (int from = covered.nextSetBit(0); from >= 0; from = covered.nextSetBit(to)) {
      to = covered.nextClearBit(from);
      double sharedMm = places.get(to - 1).alongMm() - places.get(from).alongMm();
      if (sharedMm <= MIN_SHARED_WIDTHS * sameMm && to - from < places.size()) {
        covered.clear(from, to);
      }
    }
  }

  /** A piece of a line, its ends on whole millimetres; empty if it is too short. */
  private static List<Point> rounded(List<Place> piece) {
    List<Point> points = new ArrayList<>();
    points.add(Polyline.rounded(piece.get(0).point()));
    piece.stream().skip(1).filter(Place::isCorner).map(Place::point).forEach(points::add);
    points.add(Polyline.rounded(piece.get(piece.size() - 1).point()));
    return Polyline.lengthMm(points) < MIN_MM ? List.of() : Polyline.simplified(points, 0);
  }

  /** Joins {@code line} with the chains that it meets. */
  private void chain(Line line) {
    Line chain = line;
    for (int i = chains.size() - 1; i >= 0; i--) {
      Line joined = join(chains.get(i), chain);
      if (joined != null) {
        chains.remove(i);
        chain = joined;
      }
    }
    chains.add(chain);
  }

  private @Nullable Line join(Line a, Line b) {
    if (!a.ink().equals(b.ink()) || isClosed(a.path(), sameMm) || isClosed(b.path(), sameMm)) {
      return null;
    }
    for (Polyline first : List.of(a.path(), a.path().reversed())) {
      for (Polyline second : List.of(b.path(), b.path().reversed())) {
        if (first.end().distanceMm(second.start()) <= sameMm) {
          List<Point> points = new ArrayList<>(first.points());
          points.addAll(second.points());
          return new Line(new Polyline(Polyline.simplified(points, 0)), a.ink());
        }
      }
    }
    return null;
  }

  private static boolean isClosed(Polyline path, double nearMm) {
    return path.lengthMm() > 2 * nearMm && path.start().distanceMm(path.end()) <= nearMm;
  }

  private void cut(Line chain, double longestMm) {
    // Only now: simplified at each joint, a long arc of short lines would become one chord.
    List<Point> simple = Polyline.simplified(chain.path().points(), STRAIGHT_MM);
    List<Point> points = simple.size() > 1 ? simple : chain.path().points();
    for (int from = 0; from < points.size() - 1; from += MAX_LEGS) {
      int to = Math.min(from + MAX_LEGS, points.size() - 1);
      Polyline part = new Polyline(points.subList(from, to + 1));
      double lengthMm = part.lengthMm();
      boolean isRing = isClosed(part, 2 * sameMm);
      int pieces = Math.max((int) StrictMath.ceil(lengthMm / longestMm), isRing ? 2 : 1);
      for (int i = 0; i < pieces; i++) {
        Polyline piece = part.between(lengthMm * i / pieces, lengthMm * (i + 1) / pieces);
        strokes.add(new Stroke(strokes.size(), piece, chain.ink()));
      }
    }
  }
}
