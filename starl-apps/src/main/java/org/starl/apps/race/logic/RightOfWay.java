package org.starl.apps.race.logic;

import java.util.Comparator;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.apps.race.logic.RaceFact.Way;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.geocast.Geocast;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.time.Time;

/**
 * Decides which robot goes first where robots hold each other up. A robot that gets no nearer to
 * its point asks the robots around the point, by Geocast, to make way. The nearest robot that asks
 * has the right of way for 8 s; all others that have heard it draw back meanwhile. Safety does not
 * depend on it: a robot that has not heard is only in the way for longer. Strand only.
 */
public final class RightOfWay {

  /** So long a robot has the way. */
  public static final long LASTS_NS = 8 * Time.NS_PER_S;

  private static final long ASK_MS = 2_000;
  private static final double AREA_RADII = 12;

  private static final Comparator<Held> NEAREST =
      Comparator.comparingInt((Held held) -> held.ask.distanceMm).thenComparing(held -> held.robot);

  private final GlobalVarHolder gvh;
  private final double areaMm;
  private final Geocast<Ask> geocast;
  private @Nullable Held held;
  private long askedNs = -LASTS_NS;

  /** A robot at this distance from a point asks for the way to it. */
  record Ask(int point, int distanceMm) {
    static final Shape<Ask> SHAPE =
        Shapes.of(
            Ask.class,
            Shapes.part("point", Shapes.U16, Ask::point),
            Shapes.part("distanceMm", Shapes.INT, Ask::distanceMm),
            Ask::new);
  }

  private record Held(RobotId robot, Ask ask, long sinceNs) {}

  RightOfWay(GlobalVarHolder gvh, String xid) {
    this.gvh = gvh;
    areaMm = AREA_RADII * gvh.plat.moat.parameters().robotRadiusMm();
    geocast = new Geocast<>(gvh, xid, Ask.SHAPE, this::heard, Scoreboard.SETTINGS);
  }

  /** This robot, at this distance from {@code point}, gets no nearer. */
  void ask(int point, Point at, double distanceMm) {
    askedNs = gvh.plat.clock.nowNs();
    Ask ask = new Ask(point, (int) distanceMm);
    heard(gvh.id.name(), ask);
    geocast.do_geocast(ask, new Circle(at, areaMm), ASK_MS);
  }

  /**
   * Whether this robot may ask for the way to {@code point}, from this distance: it has not asked a
   * short time ago, and no robot that is nearer has the way.
   */
  boolean mayAsk(int point, double distanceMm) {
    boolean isNearest = held == null || (int) distanceMm < held.ask.distanceMm;
    return gvh.plat.clock.nowNs() - askedNs >= LASTS_NS && (isNearest || !isOthers(point));
  }

  /** Whether another robot has the way to {@code point}. */
  boolean isOthers(int point) {
    return isHeld(point) && held != null && !held.robot.equals(gvh.id.name());
  }

  private boolean isHeld(int point) {
    return held != null
        && held.ask.point == point
        && gvh.plat.clock.nowNs() - held.sinceNs < LASTS_NS;
  }

  private void heard(RobotId robot, Ask ask) {
    Held wanted = new Held(robot, ask, gvh.plat.clock.nowNs());
    if (held == null || !isHeld(ask.point) || NEAREST.compare(wanted, held) < 0) {
      held = wanted;
      gvh.trace.action(Way.SHAPE, new Way(robot, ask.point(), ask.distanceMm()));
    }
  }
}
