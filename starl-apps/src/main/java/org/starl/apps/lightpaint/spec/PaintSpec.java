package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintTrace;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * What painters owe. Positions are true ones, every 10 ms; the tolerance is the caller's.
 *
 * <ul>
 *   <li>{@code OnTheDrawing}: wherever a light is on, it is on the stroke that it says, in that
 *       stroke's ink.
 *   <li>{@code Once}: no place of a stroke is painted twice.
 *   <li>{@code Complete}: when all painters have ended and none of them is down, all is painted.
 *   <li>{@code Painted}: all is painted and all have ended within the bound, counted anew after
 *       faults and while nobody is down.
 * </ul>
 */
public final class PaintSpec implements Monitor {

  static final String ON_THE_DRAWING = "OnTheDrawing";
  static final String ONCE = "Once";
  static final String COMPLETE = "Complete";
  static final String PAINTED = "Painted";

  private static final String ALL = "all";
  private static final int MOST_NAMED = 8;

  private final List<Stroke> strokes;
  private final double toleranceMm;
  private final Coverage coverage;
  private final Circumstances circumstances = new Circumstances();
  private final Within<String> progress;
  private final SortedMap<RobotId, Boolean> ended = new TreeMap<>();
  private final SortedSet<String> told = new TreeSet<>();
  private final LightTrail trail;
  private @Nullable Report report;
  private long nowNs;

  /**
   * @param toleranceMm how far a light may be off its stroke, and by how much what two passes of a
   *     stroke have painted may overlap or be apart
   * @param boundNs for all of the drawing
   */
  public PaintSpec(List<Stroke> strokes, double toleranceMm, long boundNs) {
    this.strokes = List.copyOf(strokes);
    this.toleranceMm = toleranceMm;
    coverage = new Coverage(strokes, toleranceMm);
    progress = new Within<>(boundNs);
    trail = new LightTrail(this::painted);
  }

  @Override
  public List<String> lemmas() {
    return List.of(ON_THE_DRAWING, ONCE, COMPLETE, PAINTED);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case ON_THE_DRAWING ->
          "Wherever a light is on, it is on the stroke that it names, in its ink.";
      case ONCE -> "No place of a stroke is painted twice.";
      case COMPLETE ->
          "When all painters have ended and none is down, the whole drawing is painted.";
      case PAINTED -> "All is painted, and all have ended, within the bound.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report to) {
    report = to;
    nowNs = event.timeNs();
    expire(to);
    trail.observe(event);
    if (circumstances.observe(event)) {
      progress.assumeAll(circumstances.isFair() && areAllUp(), nowNs);
    }
    switch (event) {
      case TraceEvent.Joined joined -> {
        ended.putIfAbsent(joined.robot(), false);
        progress.owe(ALL, nowNs);
      }
      case Variable variable -> {
        if (variable.source().equals(PaintTrace.SOURCE)
            && variable.name().equals(PaintTrace.LOCATION)) {
          boolean isDone = variable.value().equals(Location.DONE.name());
          ended.put(variable.robot(), isDone);
          if (isDone && areAllDone()) {
            allHaveEnded(to);
          }
        }
      }
      default -> {
        // Paints nothing and ends nothing.
      }
    }
  }

  @Override
  public void finish(long endNs, Report to) {
    report = to;
    nowNs = endNs;
    trail.advance(endNs);
    expire(to);
  }

  private boolean areAllUp() {
    return ended.keySet().stream().allMatch(circumstances::isUp);
  }

  private boolean areAllDone() {
    return !ended.containsValue(false);
  }

  private void allHaveEnded(Report to) {
    to.checked(COMPLETE);
    List<Integer> missing = coverage.missing();
    if (!missing.isEmpty() && areAllUp()) {
      to.violated(COMPLETE, nowNs, List.copyOf(ended.keySet()), "not painted: " + names(missing));
    }
    if (missing.isEmpty() && progress.settle(ALL)) {
      to.checked(PAINTED);
    }
  }

  private void expire(Report to) {
    progress.expire(
        nowNs,
        (key, sinceNs, deadlineNs) -> {
          List<RobotId> late = new ArrayList<>(ended.keySet());
          late.removeIf(robot -> Boolean.TRUE.equals(ended.get(robot)));
          to.checked(PAINTED);
          to.violated(
              PAINTED,
              deadlineNs,
              late,
              "since "
                  + sinceNs / 1_000_000
                  + " ms not all is done; not painted: "
                  + names(coverage.missing()));
        });
  }

  private void painted(Pass pass) {
    Report to = report;
    if (to == null) {
      return;
    }
    Point at = pass.points().get(pass.points().size() - 1);
    if (pass.points().size() == 1) {
      to.checked(ON_THE_DRAWING);
      to.checked(ONCE);
    }
    String who = pass.robot() + " " + pass.stroke();
    boolean isStroke = pass.stroke() >= 0 && pass.stroke() < strokes.size();
    if (!isStroke || !strokes.get(pass.stroke()).ink().equals(pass.ink())) {
      violated(ON_THE_DRAWING, pass, "paints " + pass.ink() + ": no such stroke", to);
      return;
    }
    double offMm = strokes.get(pass.stroke()).path().distanceMm(at);
    if (offMm > toleranceMm) {
      violated(ON_THE_DRAWING, pass, "its light is on " + text(offMm) + " off " + who, to);
    }
    coverage.add(pass);
    double twiceMm = coverage.twiceMm(pass);
    if (twiceMm > toleranceMm) {
      violated(ONCE, pass, "paints " + text(twiceMm) + " of it once more", to);
    }
  }

  private void violated(String lemma, Pass pass, String what, Report to) {
    if (told.add(lemma + " " + pass.robot() + " " + pass.stroke())) {
      to.violated(lemma, nowNs, List.of(pass.robot()), "stroke " + pass.stroke() + ": " + what);
    }
  }

  private static String text(double mm) {
    return String.format(Locale.ROOT, "%.1f mm", mm);
  }

  private String names(List<Integer> missing) {
    StringBuilder text = new StringBuilder();
    for (int number : missing.subList(0, Math.min(MOST_NAMED, missing.size()))) {
      text.append("stroke ")
          .append(number)
          .append(" (")
          .append(text(coverage.longestGapMm(number)))
          .append(") ");
    }
    int more = missing.size() - MOST_NAMED;
    return more > 0
        ? text.append("and ").append(more).append(" more").toString()
        : text.toString().strip();
  }
}
