package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintTrace;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of light painting, from true positions, every 10 ms.
 *
 * <ul>
 *   <li>{@code OnTheDrawing}: wherever a light is on, it is on the stroke that it names, in that
 *       stroke's ink.
 *   <li>{@code Once}: no place of a stroke is painted twice.
 *   <li>{@code Complete}: when all painters have ended and none is down, all is painted.
 *   <li>{@code Painted}: all is painted and all have ended within the bound. It is suspended during
 *       faults and while a robot is down, and then starts anew.
 * </ul>
 */
public final class PaintSpec implements Monitor {

  static final String ON_THE_DRAWING = "OnTheDrawing";
  static final String ONCE = "Once";
  static final String COMPLETE = "Complete";
  static final String PAINTED = "Painted";

  private static final String ALL = "all";
  private static final int MAX_NAMED = 8;

  private final List<Stroke> strokes;
  private final double toleranceMm;
  private final Coverage coverage;
  private final FaultState circumstances = new FaultState();
  private final Within<String> progress;
  private final SortedMap<RobotId, Boolean> ended = new TreeMap<>();

  /** The lemmas violated so far, with robot and stroke: each is reported once. */
  private final SortedSet<String> reported = new TreeSet<>();

  private final LightTrail trail;
  private @Nullable Report report;
  private long nowNs;

  /**
   * @param toleranceMm maximum distance of a light from its stroke, and maximum overlap of, or gap
   *     between, two passes along a stroke
   * @param boundNs time for the whole drawing
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
  public String description(String lemma) {
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
      progress.assumeAll(circumstances.isFaultFree() && areAllUp(), nowNs);
    }
    switch (event) {
      case TraceEvent.Joined joined -> {
        ended.putIfAbsent(joined.robot(), false);
        progress.start(ALL, nowNs);
      }
      case Variable variable when PaintTrace.is(variable, PaintTrace.LOCATION) -> {
        boolean isDone = variable.value().equals(Location.DONE.name());
        ended.put(variable.robot(), isDone);
        if (isDone && !ended.containsValue(false)) {
          allHaveEnded(to);
        }
      }
      default -> {
        // No other event concerns the painters' ends.
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

  private void allHaveEnded(Report to) {
    to.checked(COMPLETE);
    List<Integer> missing = coverage.missing();
    if (!missing.isEmpty() && areAllUp()) {
      to.violated(COMPLETE, nowNs, List.copyOf(ended.keySet()), "not painted: " + names(missing));
    }
    if (missing.isEmpty() && progress.stop(ALL)) {
      to.checked(PAINTED);
    }
  }

  private void expire(Report to) {
    progress.expire(
        nowNs,
        (key, sinceNs, deadlineNs) -> {
          List<RobotId> late = new ArrayList<>(ended.keySet());
          late.removeIf(robot -> Boolean.TRUE.equals(ended.get(robot)));
          String detail =
              "not done since %d ms; not painted: %s"
                  .formatted(sinceNs / 1_000_000, names(coverage.missing()));
          to.checked(PAINTED);
          to.violated(PAINTED, deadlineNs, late, detail);
        });
  }

  /** The pass has one more point. */
  private void painted(Pass pass) {
    Report to = report;
    if (to == null) {
      return;
    }
    List<Point> points = pass.points();
    if (points.size() == 1) {
      to.checked(ON_THE_DRAWING);
      to.checked(ONCE);
    }
    boolean isStroke = pass.stroke() >= 0 && pass.stroke() < strokes.size();
    if (!isStroke || !strokes.get(pass.stroke()).ink().equals(pass.ink())) {
      violated(ON_THE_DRAWING, pass, "paints " + pass.ink() + ": no such stroke", to);
      return;
    }
    Polyline path = strokes.get(pass.stroke()).path();
    double offMm = path.distanceMm(points.get(points.size() - 1));
    if (offMm > toleranceMm) {
      violated(ON_THE_DRAWING, pass, "its light is on " + text(offMm) + " off the stroke", to);
    }
    coverage.add(pass);
    double twiceMm = coverage.twiceMm(pass);
    if (twiceMm > toleranceMm) {
      violated(ONCE, pass, "paints " + text(twiceMm) + " of it once more", to);
    }
  }

  private void violated(String lemma, Pass pass, String problem, Report to) {
    if (reported.add(lemma + " " + pass.robot() + " " + pass.stroke())) {
      to.violated(lemma, nowNs, List.of(pass.robot()), "stroke " + pass.stroke() + ": " + problem);
    }
  }

  private static String text(double mm) {
    return String.format(Locale.ROOT, "%.1f mm", mm);
  }

  private String names(List<Integer> missing) {
    String names =
        missing.stream()
            .limit(MAX_NAMED)
            .map(number -> "stroke " + number + " (" + text(coverage.longestGapMm(number)) + ")")
            .collect(Collectors.joining(" "));
    int more = missing.size() - MAX_NAMED;
    return more > 0 ? names + " and " + more + " more" : names;
  }
}
