package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass.Reading;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of light painting, from true positions, every 10 ms.
 *
 * <ul>
 *   <li>{@code OnTheDrawing}: wherever a light is on, it is on the stroke that it names, in that
 *       stroke's ink.
 *   <li>{@code Once}: no place of a stroke is painted twice. Where a stroke comes near to itself, a
 *       pass counts as painting whichever of the near places was not painted before.
 *   <li>{@code Complete}: when all painters have ended and none is down, all is painted.
 *   <li>{@code Painted}: all is painted and all have ended within the bound. It is suspended during
 *       faults and while a robot is down, and then starts anew.
 * </ul>
 */
public final class PaintSpec implements Monitor {

  private static final String ON_THE_DRAWING = "lightpaint.OnTheDrawing";
  private static final String ONCE = "lightpaint.Once";
  private static final String COMPLETE = "lightpaint.Complete";
  private static final String PAINTED = "lightpaint.Painted";

  private static final String ALL = "all";
  private static final int MAX_NAMED = 8;

  private final List<Stroke> strokes;
  private final double toleranceMm;
  private final FaultState faults = new FaultState();
  private final Within<String> progress;
  private final SortedMap<RobotId, Boolean> ended = new TreeMap<>();

  /** The lemmas violated so far, with robot and stroke: each is reported once. */
  private final SortedSet<String> reported = new TreeSet<>();

  private final LightTrail trail = new LightTrail(new Bodies(), this::painted);
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
    progress = new Within<>(boundNs);
  }

  @Override
  public List<String> lemmas() {
    return List.of(ON_THE_DRAWING, ONCE, COMPLETE, PAINTED);
  }

  @Override
  public List<String> progressLemmas() {
    return List.of(PAINTED);
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
    if (faults.observe(event)) {
      progress.assumeAll(faults.isFaultFree() && areAllUp(), nowNs);
    }
    switch (event) {
      case TraceEvent.Joined joined -> {
        ended.putIfAbsent(joined.robot(), false);
        progress.start(ALL, nowNs);
      }
      case Variable variable when variable.of(PaintFact.LOCATION) != null -> {
        boolean isDone = variable.of(PaintFact.LOCATION) == Location.DONE;
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
    return ended.keySet().stream().allMatch(faults::isUp);
  }

  private void allHaveEnded(Report to) {
    to.checked(COMPLETE);
    String missing = missing();
    if (!missing.isEmpty() && areAllUp()) {
      to.violated(COMPLETE, nowNs, List.copyOf(ended.keySet()), "not painted: " + missing);
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
          String since = "not done since " + sinceNs / Time.NS_PER_MS + " ms; not painted: ";
          to.checked(PAINTED);
          to.overdue(PAINTED, deadlineNs, late, since + missing());
        });
  }

  /** The pass has one more point. */
  private void painted(Pass pass) {
    Report to = report;
    if (to == null) {
      return;
    }
    if (pass.points().size() == 1) {
      to.checked(ON_THE_DRAWING);
      to.checked(ONCE);
    }
    boolean isStroke = pass.stroke() >= 0 && pass.stroke() < strokes.size();
    if (!isStroke || !strokes.get(pass.stroke()).ink().equals(pass.ink())) {
      violated(ON_THE_DRAWING, pass, "paints " + pass.ink() + ": no such stroke", to);
      return;
    }
    Polyline path = strokes.get(pass.stroke()).path();
    double offMm = path.distanceMm(pass.latest());
    if (offMm > toleranceMm) {
      violated(ON_THE_DRAWING, pass, "its light is on " + text(offMm) + " off the stroke", to);
    }
    pass.read(path, toleranceMm);
    Reading reading = reading(pass);
    double twiceMm = reading == null ? 0 : twiceMm(pass, reading);
    if (twiceMm > toleranceMm) {
      violated(ONCE, pass, "paints " + text(twiceMm) + " of it once more", to);
    }
  }

  private void violated(String lemma, Pass pass, String problem, Report to) {
    if (reported.add(lemma + " " + pass.robot() + " " + pass.stroke())) {
      to.violated(lemma, nowNs, List.of(pass.robot()), "stroke " + pass.stroke() + ": " + problem);
    }
  }

  private List<Pass> passes(int stroke) {
    return trail.passes().stream()
        .filter(pass -> pass.stroke() == stroke)
        .collect(Collectors.toList());
  }

  /** The likeliest reading of a pass, beside the other passes; null if it has none. */
  private @Nullable Reading reading(Pass pass) {
    return pass.readings().stream()
        .min(Reading.likeliest(toleranceMm, reading -> twiceMm(pass, reading)))
        .orElse(null);
  }

  /**
   * The longest part, in mm, that {@code pass} painted although it, or another pass, had already.
   */
  private double twiceMm(Pass pass, Reading reading) {
    double twiceMm = reading.backMm();
    for (Pass other : passes(pass.stroke())) {
      if (other != pass) {
        double commonMm =
            other.readings().stream()
                .min(Reading.likeliest(toleranceMm, Reading::backMm))
                .map(reading::commonMm)
                .orElse(0.0);
        twiceMm = Math.max(twiceMm, commonMm);
      }
    }
    return twiceMm;
  }

  /** What was painted of a stroke, from its start on. */
  private List<Reading> parts(Stroke stroke) {
    return passes(stroke.number()).stream()
        .map(this::reading)
        .filter(Objects::nonNull)
        .sorted(Comparator.comparingDouble(Reading::fromMm))
        .collect(Collectors.toList());
  }

  /** The longest unpainted part of a stroke, in mm. */
  private double longestGapMm(Stroke stroke) {
    double gapMm = 0;
    double toMm = 0;
    for (Reading part : parts(stroke)) {
      gapMm = Math.max(gapMm, part.fromMm() - toMm);
      toMm = Math.max(toMm, part.toMm());
    }
    return Math.max(gapMm, stroke.path().lengthMm() - toMm);
  }

  /** The first strokes with a gap longer than the tolerance; empty if there are none. */
  private String missing() {
    List<String> missing = new ArrayList<>();
    for (Stroke stroke : strokes) {
      double gapMm = longestGapMm(stroke);
      if (gapMm > toleranceMm || parts(stroke).isEmpty()) {
        missing.add("stroke " + stroke.number() + " (" + text(gapMm) + ")");
      }
    }
    int more = missing.size() - MAX_NAMED;
    return missing.stream().limit(MAX_NAMED).collect(Collectors.joining(" "))
        + (more > 0 ? " and " + more + " more" : "");
  }

  private static String text(double mm) {
    return String.format(Locale.ROOT, "%.1f mm", mm);
  }
}
