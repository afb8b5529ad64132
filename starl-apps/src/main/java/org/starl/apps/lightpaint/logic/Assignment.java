package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.geocast.Broadcast;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.time.Time;

/**
 * Which painter paints which stroke. A {@link SetAgreement} for each stroke assigns it to one
 * painter for ever: so it is painted once. In addition, painters broadcast {@link Hint}s, so that
 * they rarely drive to the same stroke. Strand only.
 */
final class Assignment {

  private static final Shape<RobotId> PAINTER = Shapes.text("robot", RobotId::name, RobotId::new);
  private static final long HINT_PERIOD_MS = 4_000;
  private static final long HINT_LIFETIME_NS = 15 * Time.NS_PER_S;

  private static final double DRIVE_MM_PER_S = 200;
  private static final double EQUALLY_FAR_MM = 200;

  /** Without progress for so long, the work is blocked by something that will not move. */
  private static final long GIVE_UP_NS = 240 * Time.NS_PER_S;

  private final GlobalVarHolder gvh;
  private final List<Stroke> strokes;
  private final double apartMm;
  private final List<SetAgreement<RobotId>> agreements = new ArrayList<>();
  private final Broadcast<Hint> hints;
  private final SortedMap<RobotId, Received> received = new TreeMap<>();

  /** Until when strokes that could not be reached are left alone, by their numbers. */
  private final SortedMap<Integer, Long> postponedToNs = new TreeMap<>();

  private Hint sent = Hint.INITIAL;
  private long sendAgainNs;
  private int progress;
  private long progressNs;

  private record Received(RobotId from, Hint hint, long atNs) {}

  /**
   * @param apartMm strokes that are nearer to each other cannot be painted at the same time
   */
  Assignment(GlobalVarHolder gvh, List<Stroke> strokes, double apartMm) {
    this.gvh = gvh;
    this.strokes = strokes;
    this.apartMm = apartMm;
    for (Stroke stroke : strokes) {
      String xid = LightPaintApp.XID + ".stroke" + stroke.number();
      agreements.add(new SetAgreement<>(gvh, xid, PAINTER));
    }
    hints = new Broadcast<>(gvh, LightPaintApp.XID, Hint.SHAPE, this::received);
    progressNs = nowNs();
  }

  /** Asks that {@code stroke} be assigned to this robot, until it is assigned to some robot. */
  void request(Stroke stroke) {
    agreements.get(stroke.number()).propose(gvh.id.name());
  }

  /** Whether the latest request has passed its deadline. */
  boolean hasFailed(Stroke stroke) {
    return agreements.get(stroke.number()).failed().get();
  }

  /** The painter of the stroke; null if none is known to this robot. */
  private @Nullable RobotId painter(Stroke stroke) {
    return agreements.get(stroke.number()).decided().get()
            instanceof Decision.Decided<RobotId> decided
        ? decided.value()
        : null;
  }

  boolean isOwn(Stroke stroke) {
    return gvh.id.name().equals(painter(stroke));
  }

  boolean isOfAnother(Stroke stroke) {
    return painter(stroke) != null && !isOwn(stroke);
  }

  /** How many strokes are unassigned, as far as this robot knows. */
  int unassigned() {
    return (int) strokes.stream().filter(stroke -> painter(stroke) == null).count();
  }

  /**
   * The nearest unassigned stroke that no other painter works near to, or will sooner; null if there
   * is none now.
   *
   * @param isClear whether a tube along a stroke could be claimed now
   */
  @Nullable Stroke nearestFree(Point here, Predicate<Stroke> isClear) {
    return strokes.stream()
        .filter(stroke -> painter(stroke) == null)
        .filter(stroke -> nowNs() >= postponedToNs.getOrDefault(stroke.number(), Long.MIN_VALUE))
        .filter(stroke -> !isContested(stroke, here))
        .sorted(Comparator.comparingDouble(stroke -> endsMm(stroke.path(), here)))
        .filter(isClear)
        .findFirst()
        .orElse(null);
  }

  private static double endsMm(Polyline path, Point here) {
    return Math.min(path.start().distanceMm(here), path.end().distanceMm(here));
  }

  /** Whether this robot, on its way to {@code stroke}, should choose another one. */
  boolean isContested(Stroke stroke, Point here) {
    double awayMm = endsMm(stroke.path(), here);
    return painter(stroke) == null
        ? rivals(stroke).anyMatch(rival -> rival.hint().paints() || isNearer(rival, awayMm))
        : isOfAnother(stroke);
  }

  /** Whether the rival will be at its stroke before this robot; equally soon, whether by name. */
  private boolean isNearer(Received rival, double awayMm) {
    double drivenMm = DRIVE_MM_PER_S * (nowNs() - rival.atNs()) / Time.NS_PER_S;
    double nearerMm = awayMm - Math.max(0, rival.hint().awayMm() - drivenMm);
    return Math.abs(nearerMm) < EQUALLY_FAR_MM ? isBeforeThis(rival) : nearerMm > 0;
  }

  /**
   * Whether a robot with a smaller name was assigned a stroke that is too near to {@code stroke}.
   */
  boolean mustWait(Stroke stroke) {
    return rivals(stroke).anyMatch(rival -> rival.hint().paints() && isBeforeThis(rival));
  }

  private boolean isBeforeThis(Received rival) {
    return rival.from().compareTo(gvh.id.name()) < 0;
  }

  /** The latest hints of the robots that work too near to {@code stroke}. */
  private Stream<Received> rivals(Stroke stroke) {
    return received.values().stream()
        .filter(other -> nowNs() - other.atNs() < HINT_LIFETIME_NS)
        .filter(other -> other.hint().stroke() != CurrentWork.NONE)
        .filter(other -> {
          Polyline path = strokes.get(other.hint().stroke()).path();
          return stroke.path().distanceMm(path) < apartMm;
        });
  }

  /** Leaves {@code stroke} alone for a while: there is no path to it, or no room at it, now. */
  void postpone(Stroke stroke, long forNs) {
    postponedToNs.put(stroke.number(), nowNs() + forNs);
  }

  boolean wasPostponed(Stroke stroke) {
    return postponedToNs.containsKey(stroke.number());
  }

  /**
   * How many strokes this robot has painted.
   *
   * @param current number of the stroke that it still works on, or {@link CurrentWork#NONE}
   */
  int finished(int current) {
    return (int) strokes.stream().filter(this::isOwn).filter(s -> s.number() != current).count();
  }

  /**
   * Broadcasts which stroke this robot works on: when that changes, and periodically.
   *
   * @param current as for {@link #finished}
   * @param isGivingWay whether it leaves the strokes near {@code current} to others for now
   */
  void sendHint(int current, boolean isGivingWay, Point here) {
    Hint hint = new Hint(CurrentWork.NONE, false, finished(current), 0);
    if (current != CurrentWork.NONE && !isGivingWay) {
      Stroke stroke = strokes.get(current);
      hint = new Hint(current, isOwn(stroke), hint.finished(), (int) endsMm(stroke.path(), here));
    }
    if (!hint.isLike(sent) || nowNs() >= sendAgainNs) {
      sent = hint;
      sendAgainNs = nowNs() + HINT_PERIOD_MS * Time.NS_PER_MS;
      hints.BCast(hint, HINT_PERIOD_MS / 2);
    }
  }

  /** Whether there was no progress for so long that there will be none. */
  boolean isHopeless() {
    return withoutProgressNs() > GIVE_UP_NS;
  }

  /** Whether it has been hopeless for so long that this robot will get no path home either. */
  boolean isHopelessForLong() {
    return withoutProgressNs() > 2 * GIVE_UP_NS;
  }

  /** For how long no stroke was assigned or finished, as far as this robot knows. */
  private long withoutProgressNs() {
    int now = strokes.size() - unassigned() + sent.finished();
    for (Received other : received.values()) {
      now += other.hint().finished();
    }
    if (now > progress) {
      progress = now;
      progressNs = nowNs();
    }
    return nowNs() - progressNs;
  }

  private void received(RobotId from, Hint hint) {
    if (hint.stroke() < strokes.size()) {
      received.put(from, new Received(from, hint, nowNs()));
    }
  }

  private long nowNs() {
    return gvh.plat.clock.nowNs();
  }
}
