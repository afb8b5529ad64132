package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.gvh.GvhCell;
import org.starl.motion.MotionFlag;
import org.starl.primitives.mutex.PipelinePrim;
import org.starl.primitives.registration.Registration;
import org.starl.time.Time;

/**
 * One drive from a private vertex over stops to another one. It requests all sections of its way as one
 * sequence, in the order in which the robot needs them first, drives on while it holds what it needs up to
 * a vertex ahead, and releases each section when the body has left it and does not come back. At its end
 * it holds nothing. Strand only; from {@code callStarL}, because it waits for a registration.
 */
final class Journey {

  private static final long RETRY_NS = Time.NS_PER_S;
  private static final long REGISTER_MS = 60_000;

  // Vertices on a straight line are passed without a stop. On a long way to its goal a robot misses
  // its lane by more, so a long lane has goals between its vertices.
  private static final double LONGEST_MM = 4_000;
  private static final double BETWEEN_MM = 2_000;
  private static final double STRAIGHT_MM = 10;

  // Farther beside its lane than this, a robot gets no farther goal: it aims at the one that it
  // has, ever more exactly.
  private static final double NEAR_MM = 15;

  private final GlobalVarHolder gvh;
  private final Roads roads;
  private final Registration reg;
  private final PipelinePrim mutex;
  private final Collection<Integer> own;
  private final GvhCell<List<Integer>> wayAhead;
  private final GvhCell<List<Integer>> lane;
  private final List<Integer> begin;
  private final List<Integer> stops;
  private final Supplier<Set<String>> shut;
  private List<Integer> vertices = List.of();
  private List<Point> points = List.of();
  private List<List<String>> needs = List.of();
  private final Set<String> stands = new TreeSet<>(); // since before a restart
  private int passed; // the robot is between this point and the next one
  private @Nullable Point goal;
  private long retryAtNs;
  private long askAtNs;

  /**
   * @param begin the first vertices, in their order
   * @param stops the vertices to which it drives then, by the shortest ways; the last one is private
   * @param shut the sections that dead robots may be in
   * @param own the robot's home, and the charger that it uses
   * @param wayAhead the traced variable {@code way}
   * @param lane the traced variable {@code lane}
   */
  Journey(
      GlobalVarHolder gvh,
      Roads roads,
      Registration reg,
      PipelinePrim mutex,
      List<Integer> begin,
      List<Integer> stops,
      Supplier<Set<String>> shut,
      Collection<Integer> own,
      GvhCell<List<Integer>> wayAhead,
      GvhCell<List<Integer>> lane) {
    this.gvh = gvh;
    this.roads = roads;
    this.reg = reg;
    this.mutex = mutex;
    this.shut = shut;
    this.own = own;
    this.wayAhead = wayAhead;
    this.lane = lane;
    this.begin = List.copyOf(begin);
    this.stops = List.copyOf(stops);
    choose(Set.of());
  }

  /** Chooses the way: around these sections, if there is such a way. */
  private void choose(Set<String> sections) {
    int last = begin.get(begin.size() - 1);
    List<Integer> all = new ArrayList<>(begin.subList(0, begin.size() - 1));
    all.addAll(roads.wayAround(last, stops, sections).orElseGet(() -> roads.way(last, stops)));
    vertices = List.copyOf(all);
    points = new ArrayList<>(vertices.stream().map(roads::at).collect(Collectors.toList()));
    needs = new ArrayList<>(roads.needs(vertices));
    tell();
  }

  /** The point of a stop, which may be on the way to an earlier one, too. */
  private int pointOf(int stop) {
    int point = begin.size() - 1;
    for (int i = 0; i <= stop; i++) {
      point += vertices.subList(point, vertices.size()).indexOf(stops.get(i));
    }
    return point;
  }

  /**
   * After a restart of the program on the first lane of this way. Call it before the first step.
   *
   * @param sections those in which the body may be: no other robot gets them, so it asks for none of them
   */
  void resume(NavGraph.Lane first, List<String> sections) {
    points.set(0, gvh.gps.pose().at());
    needs.set(0, roads.needs(points.get(0), first));
    stands.addAll(sections);
    Set<String> all = new LinkedHashSet<>(sections);
    all.addAll(needsFrom(0));
    mutex.resume(sections, List.copyOf(all));
  }

  /** The sections that no other robot gets. */
  private Set<String> mine() {
    Set<String> mine = new TreeSet<>(mutex.held());
    mine.addAll(stands);
    return mine;
  }

  /** The sections that are still needed, from this point on, in the order of the way. */
  private Set<String> needsFrom(int point) {
    Set<String> rest = new LinkedHashSet<>();
    needs.subList(Math.min(point, needs.size()), needs.size()).forEach(rest::addAll);
    return rest;
  }

  /** The last point of the way. */
  private int end() {
    return points.size() - 1;
  }

  /**
   * Takes the next step towards a stop.
   *
   * @return whether the robot stands there; at the end, whether it also has released all
   */
  boolean step(int stop) {
    request();
    int until = pointOf(stop);
    if (!gvh.gps.hasFix()) {
      return false;
    }
    advance(until);
    release();
    if (passed >= until) {
      return until < end() || mine().isEmpty();
    }
    drive(until);
    return false;
  }

  /** Requests what it needs and does not hold, again after a failure. */
  private void request() {
    long nowNs = gvh.plat.clock.nowNs();
    Set<String> rest = needsFrom(passed);
    rest.removeAll(stands);
    boolean isOver = mutex.held().containsAll(rest);
    boolean isAsked = askAtNs > 0 && !mutex.failed().get();
    if (isOver || isAsked || nowNs < askAtNs) {
      return;
    }
    if (reg.register(REGISTER_MS)) {
      if (passed == 0 && goal == null && mine().isEmpty()) {
        choose(shut.get());
        rest = needsFrom(0);
      }
      Set<String> all = new LinkedHashSet<>(mutex.held());
      all.addAll(rest);
      mutex.doSequence(List.copyOf(all));
    }
    askAtNs = gvh.plat.clock.nowNs() + RETRY_NS;
  }

  private void advance(int until) {
    Point at = gvh.gps.pose().at();
    while (passed < until && goal != null) {
      Point next = points.get(passed + 1);
      // To the goal: the next point may be a few mm behind a robot that has restarted at a vertex.
      Point along = goal.minus(points.get(passed));
      boolean isHere =
          next.equals(goal)
              ? gvh.plat.moat.motionflag().get() == MotionFlag.DONE
              : at.minus(next).dot(along) >= 0;
      if (!isHere) {
        return;
      }
      passed++;
      goal = next.equals(goal) ? null : goal;
      tell();
    }
  }

  private void tell() {
    wayAhead.set(vertices.subList(Math.min(passed + 1, vertices.size()), vertices.size()));
    boolean isDriving = passed < end() && goal != null;
    lane.set(isDriving ? vertices.subList(passed, passed + 2) : List.of());
  }

  private void release() {
    Set<String> rest = needsFrom(passed);
    Point at = gvh.gps.pose().at();
    Set<String> left = mine();
    left.removeIf(
        section -> rest.contains(section) || !roads.isClear(section, at, gvh.gps.errorMm(), own));
    if (!left.isEmpty()) {
      mutex.release(left);
      stands.removeAll(left);
    }
  }

  private void drive(int until) {
    int reach = passed;
    while (reach < until && mine().containsAll(needs.get(reach)) && isStraight(reach + 1)) {
      reach++;
    }
    if (gvh.plat.moat.motionflag().get() == MotionFlag.FAIL && goal != null) {
      goal = null;
      retryAtNs = gvh.plat.clock.nowNs() + RETRY_NS;
    }
    Point target = reach == passed + 1 ? onLane(points.get(reach)) : points.get(reach);
    boolean isAiming = goal != null && gvh.plat.moat.motionflag().get() != MotionFlag.DONE;
    boolean mayAim = gvh.plat.clock.nowNs() >= retryAtNs && (!isAiming || isNearLane());
    if (reach > passed && !target.equals(goal) && mayAim) {
      goal = target;
      tell();
      gvh.plat.moat.doMove(new ItemPosition("v" + vertices.get(reach), target.xMm(), target.yMm()));
    }
  }

  /** The end of the lane, or a point of it that is not too far ahead. */
  private Point onLane(Point end) {
    Point start = points.get(passed);
    Point way = end.minus(start);
    double lengthMm = start.distanceMm(end);
    if (lengthMm <= LONGEST_MM) {
      return end;
    }
    double reachMm = gvh.gps.pose().at().minus(start).dot(way) / lengthMm + LONGEST_MM;
    return reachMm >= lengthMm
        ? end
        : start.plus(way.times(Math.floor(reachMm / BETWEEN_MM) * BETWEEN_MM / lengthMm));
  }

  private boolean isNearLane() {
    Segment its = new Segment(points.get(passed), points.get(passed + 1));
    return its.distanceMm(gvh.gps.pose().at()) <= NEAR_MM;
  }

  /** Whether the points up to this one are on one line. */
  private boolean isStraight(int last) {
    Segment line = new Segment(points.get(passed), points.get(last));
    if (last > passed + 1 && line.from().distanceMm(line.to()) > LONGEST_MM) {
      return false;
    }
    double fromMm = 0;
    for (int i = passed + 1; i < last; i++) {
      double mm = points.get(i).distanceMm(points.get(passed));
      if (line.distanceMm(points.get(i)) > STRAIGHT_MM || mm < fromMm) {
        return false;
      }
      fromMm = mm;
    }
    return true;
  }
}
