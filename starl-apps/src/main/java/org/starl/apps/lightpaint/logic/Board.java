package org.starl.apps.lightpaint.logic;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.geocast.Broadcast;

/**
 * Who paints what. Each stroke is given once, to one painter, for ever, by a {@link SetAgreement} of
 * its own among all: that is what makes it be painted once. Beside that, painters tell each other
 * what they are about, so that they seldom want the same.
 */
final class Board {

  private static final String XID = "lightpaint";
  private static final long NS_PER_MS = 1_000_000;
  private static final long REPEAT_MS = 4_000;
  private static final long FRESH_NS = 15_000 * NS_PER_MS;
  private static final long LATER_NS = 20_000 * NS_PER_MS;

  /** Where nothing becomes of the work for so long, something is in the way that will not move. */
  private static final long GIVE_UP_NS = 240_000 * NS_PER_MS;

  private final GlobalVarHolder gvh;
  private final List<Stroke> strokes;
  private final double apartMm;
  private final List<SetAgreement> painters = new ArrayList<>();
  private final Broadcast<Hint> hints;
  private final SortedMap<RobotId, Heard> others = new TreeMap<>();

  /** Strokes that could not be come to, and until when they are left alone. */
  private final SortedMap<Integer, Long> laterNs = new TreeMap<>();

  private Hint own = new Hint(Hint.NONE, false, 0);
  private long repeatNs;
  private int given;
  private int finishedByOthers;
  private long newsNs;

  private record Heard(Hint hint, long atNs) {}

  /**
   * @param apartMm strokes that are nearer to each other cannot be painted at the same time
   */
  Board(GlobalVarHolder gvh, List<Stroke> strokes, double apartMm) {
    this.gvh = gvh;
    this.strokes = strokes;
    this.apartMm = apartMm;
    for (Stroke stroke : strokes) {
      painters.add(new SetAgreement(gvh, XID + ".stroke" + stroke.number()));
    }
    hints = new Broadcast<>(gvh, XID, new Hint.HintCodec(), this::heard);
    newsNs = nowNs();
  }

  /** Works for {@code stroke} being given to this robot, until it is given to somebody. */
  void ask(Stroke stroke) {
    byte[] name = gvh.id.name().name().getBytes(StandardCharsets.UTF_8);
    painters.get(stroke.number()).propose(name);
  }

  boolean hasGivenUp(Stroke stroke) {
    return painters.get(stroke.number()).failed().get();
  }

  /** Whose the stroke is; null as long as this robot does not know that it is anybody's. */
  private @Nullable RobotId painter(Stroke stroke) {
    Decision decision = painters.get(stroke.number()).decided().get();
    return decision instanceof Decision.Decided decided
        ? new RobotId(new String(decided.value().bytes(), StandardCharsets.UTF_8))
        : null;
  }

  boolean isMine(Stroke stroke) {
    return gvh.id.name().equals(painter(stroke));
  }

  boolean isOthers(Stroke stroke) {
    return painter(stroke) != null && !isMine(stroke);
  }

  /** How many strokes are this robot's. */
  private int mine() {
    int count = 0;
    for (Stroke stroke : strokes) {
      count += isMine(stroke) ? 1 : 0;
    }
    return count;
  }

  /** How many strokes are nobody's, as far as this robot knows. */
  int left() {
    int count = 0;
    for (Stroke stroke : strokes) {
      count += painter(stroke) == null ? 1 : 0;
    }
    return count;
  }

  /** The nearest stroke that is nobody's and in nobody's way; null if there is none now. */
  @Nullable Stroke nearestFree(Point here) {
    Stroke nearest = null;
    double nearestMm = Double.POSITIVE_INFINITY;
    for (Stroke stroke : strokes) {
      if (painter(stroke) == null && !isLater(stroke) && inTheWay(stroke) == null) {
        Polyline path = stroke.path();
        double mm = Math.min(path.start().distanceMm(here), path.end().distanceMm(here));
        if (mm < nearestMm) {
          nearest = stroke;
          nearestMm = mm;
        }
      }
    }
    return nearest;
  }

  /** Whether there is something new for who found nothing: a free stroke, or none any more. */
  boolean isWorthALook(Point here) {
    return left() == 0 || nearestFree(here) != null;
  }

  /** Whether this robot, on its way to {@code stroke}, had better go elsewhere. */
  boolean isContested(Stroke stroke) {
    if (painter(stroke) != null) {
      return isOthers(stroke);
    }
    RobotId other = inTheWay(stroke);
    if (other == null) {
      return false;
    }
    Heard heard = others.get(other);
    boolean paints = heard != null && heard.hint().paints();
    return paints || other.compareTo(gvh.id.name()) < 0;
  }

  /** Whether somebody who comes first has a stroke in hand that is in the way of this robot's own. */
  boolean mustWait(Stroke stroke) {
    RobotId other = inTheWay(stroke);
    Heard heard = other == null ? null : others.get(other);
    return other != null
        && heard != null
        && heard.hint().paints()
        && other.compareTo(gvh.id.name()) < 0;
  }

  /** Leaves {@code stroke} alone for a while: there is no way to it now. */
  void later(Stroke stroke) {
    laterNs.put(stroke.number(), nowNs() + LATER_NS);
  }

  /**
   * How many strokes this robot has painted.
   *
   * @param inHand number of the stroke that it is still about
   */
  int finished(int inHand) {
    return mine() - (isMine(inHand) ? 1 : 0);
  }

  /** Says which stroke this robot is about, by its number, again where it is long ago. */
  void tell(int inHand) {
    Hint hint = new Hint(inHand, isMine(inHand), finished(inHand));
    if (!hint.equals(own) || nowNs() >= repeatNs) {
      if (hint.finished() > own.finished()) {
        newsNs = nowNs();
      }
      own = hint;
      repeatNs = nowNs() + REPEAT_MS * NS_PER_MS;
      hints.BCast(hint, REPEAT_MS / 2);
    }
  }

  /** Whether nothing has become of the work for so long that nothing will. */
  boolean isHopeless() {
    return silenceNs() > GIVE_UP_NS;
  }

  /** Whether it is hopeless for so long that whoever waits for a way home gets none either. */
  boolean isLongHopeless() {
    return silenceNs() > 2 * GIVE_UP_NS;
  }

  /** For how long nothing has become of the work, as far as this robot knows. */
  private long silenceNs() {
    int nowGiven = strokes.size() - left();
    int nowFinished = 0;
    for (Heard heard : others.values()) {
      nowFinished += heard.hint().finished();
    }
    if (nowGiven > given || nowFinished > finishedByOthers) {
      given = nowGiven;
      finishedByOthers = nowFinished;
      newsNs = nowNs();
    }
    return nowNs() - newsNs;
  }

  private boolean isMine(int number) {
    return number != Hint.NONE && isMine(strokes.get(number));
  }

  /** Of those who are about something too near to {@code stroke}, the one that comes first. */
  private @Nullable RobotId inTheWay(Stroke stroke) {
    RobotId first = null;
    for (Map.Entry<RobotId, Heard> other : others.entrySet()) {
      Hint hint = other.getValue().hint();
      boolean isFresh = nowNs() - other.getValue().atNs() < FRESH_NS;
      if (isFresh && hint.stroke() != Hint.NONE && meet(stroke, strokes.get(hint.stroke()))) {
        if (hint.paints()) {
          return other.getKey();
        }
        first = first == null ? other.getKey() : first;
      }
    }
    return first;
  }

  private boolean meet(Stroke a, Stroke b) {
    return a.path().distanceMm(b.path()) < apartMm;
  }

  private boolean isLater(Stroke stroke) {
    Long untilNs = laterNs.get(stroke.number());
    return untilNs != null && nowNs() < untilNs;
  }

  private void heard(RobotId from, Hint hint) {
    if (hint.stroke() < strokes.size()) {
      others.put(from, new Heard(hint, nowNs()));
    }
  }

  private long nowNs() {
    return gvh.plat.clock.nowNs();
  }
}
