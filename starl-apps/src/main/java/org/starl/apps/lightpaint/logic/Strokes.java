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

  /** Shorter strokes can be neither seen nor painted. */
  private static final double MIN_MM = 2;

  private final double sameMm;
  private final List<Segment> kept = new ArrayList<>();
  private final List<Line> chains = new ArrayList<>();
  private final List<Stroke> strokes = new ArrayList<>();

  private Strokes(double sameMm) {
    this.sameMm = sameMm;
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
    Strokes cutter = new Strokes(sameMm);
    List<Line> parts = new ArrayList<>();
    for (int i = lines.size() - 1; i >= 0; i--) {
      parts.addAll(0, cutter.uncovered(lines.get(i)));
    }
    parts.forEach(cutter::chain);
    cutter.chains.forEach(chain -> cutter.cut(chain, longestMm));
    return cutter.strokes;
  }

  /** The parts of {@code line} along which no kept line runs. They are kept, too. */
  private List<Line> uncovered(Line line) {
    List<Line> parts = new ArrayList<>();
    List<Point> part = new ArrayList<>();
    for (Segment leg : line.path().legs()) {
      int samples = (int) StrictMath.ceil(leg.from().distanceMm(leg.to()) / SAMPLE_MM);
      BitSet covered = covered(leg, samples);
      int to;
      for (int from = covered.nextClearBit(0); from < samples; from = covered.nextClearBit(to)) {
        to = covered.nextSetBit(from);
        to = to < 0 ? samples : to;
        Point start = Polyline.rounded(at(leg, from, samples));
        Point end = Polyline.rounded(at(leg, to, samples));
        if (!start.equals(end)) {
          if (!part.isEmpty() && !part.get(part.size() - 1).equals(start)) {
            parts.add(new Line(new Polyline(part), line.ink()));
            part.clear();
          }
          if (part.isEmpty()) {
            part.add(start);
          }
          part.add(end);
          // Only the piece, not its leg: what this line leaves out must not remove parts of others.
          kept.add(new Segment(start, end));
        }
      }
    }
    if (!part.isEmpty()) {
      parts.add(new Line(new Polyline(part), line.ink()));
    }
    return parts;
  }

  /** The samples of {@code leg} along which kept lines run. */
  private BitSet covered(Segment leg, int samples) {
    BitSet covered = new BitSet();
    List<Segment> near = new ArrayList<>(kept);
    near.removeIf(other -> other.distanceMm(leg) > sameMm);
    for (int i = 0; i <= samples && !near.isEmpty(); i++) {
      Point place = at(leg, i, samples);
      covered.set(i, near.stream().anyMatch(other -> other.distanceMm(place) <= sameMm));
    }
    double least = Math.min(samples, MIN_SHARED_WIDTHS * sameMm / SAMPLE_MM);
    int to;
    for (int from = covered.nextSetBit(0); from >= 0; from = covered.nextSetBit(to)) {
      to = covered.nextClearBit(from);
      if (to - from <= least) {
        covered.clear(from, to);
      }
    }
    return covered;
  }

  private static Point at(Segment leg, int sample, int samples) {
    return leg.from().plus(leg.to().minus(leg.from()).times(sample / (double) samples));
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
    return path.start().distanceMm(path.end()) <= nearMm;
  }

  private void cut(Line chain, double longestMm) {
    // Only now: simplified at each joint, a long arc of short lines would become one chord.
    List<Point> points = Polyline.simplified(chain.path().points(), STRAIGHT_MM);
    for (int from = 0; from < points.size() - 1; from += MAX_LEGS) {
      int to = Math.min(from + MAX_LEGS, points.size() - 1);
      Polyline part = new Polyline(points.subList(from, to + 1));
      double lengthMm = part.lengthMm();
      boolean isRing = lengthMm > 2 * sameMm && isClosed(part, 2 * sameMm);
      int pieces = Math.max((int) StrictMath.ceil(lengthMm / longestMm), isRing ? 2 : 1);
      for (int i = 0; i < pieces; i++) {
        Polyline piece = part.between(lengthMm * i / pieces, lengthMm * (i + 1) / pieces);
        if (piece.lengthMm() >= MIN_MM) {
          strokes.add(new Stroke(strokes.size(), piece, chain.ink()));
        }
      }
    }
  }
}
