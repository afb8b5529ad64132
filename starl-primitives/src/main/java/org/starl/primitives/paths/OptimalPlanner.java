package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.stream.IntStream;
import org.starl.geometry.Point;

/**
 * Finds a shortest path, or proves that there is none: A* on the visibility graph of the widened
 * obstacles (Lozano-Perez, Wesley, "An algorithm for planning collision-free paths among polyhedral
 * obstacles", CACM 22(10), 1979). A shortest path turns only at convex corners, and passes each on
 * a tangent.
 *
 * <p>The path is shortest among those outside the widened obstacles, which are polygons in whole mm
 * with eight outer chords for each quarter of a round corner. So its margin is larger than the
 * requested one by at most 2.5 mm and half a per cent.
 */
public final class OptimalPlanner implements PathPlanner {

  @Override
  public Plan plan(PlanTask task) {
    FreeSpace space = FloorPlan.of(task);
    Ends ends = Ends.of(task);
    Plan.Blocked blocked = ends.blockedIn(space);
    return blocked != null ? blocked : search(space, ends);
  }

  /** Searches a path between two free ends. */
  static Plan search(FreeSpace space, Ends ends) {
    int startRoom = space.room(ends.startX(), ends.startY());
    boolean isCutOff = startRoom != space.room(ends.goalX(), ends.goalY());
    return isCutOff ? new Plan.NoPath() : new Search(space, ends).run();
  }

  /** An edge of the graph that is not tested yet: it is tested when it leaves the queue. */
  private record Candidate(double estimateMm, double lengthMm, int node, int parent) {}

  private static final Comparator<Candidate> ORDER =
      Comparator.comparingDouble(Candidate::estimateMm)
          .thenComparingInt(Candidate::node)
          .thenComparingInt(Candidate::parent);

  private static final class Search {
    private static final int START = 0;
    private static final int GOAL = 1;
    private static final int FIRST_CORNER = 2;
    private static final int NONE = -1;

    private final FreeSpace space;
    private final int[] x;
    private final int[] y;

    /** The corner of the free space of each node from {@link #FIRST_CORNER} on. */
    private final int[] corner;

    private final int[] parent;
    private final boolean[] reached;
    private final PriorityQueue<Candidate> queue = new PriorityQueue<>(ORDER);

    Search(FreeSpace space, Ends ends) {
      this.space = space;
      IntStream corners = IntStream.range(0, space.corners()).filter(space::sticksOut);
      corner = IntStream.concat(IntStream.of(NONE, NONE), corners).toArray();
      int count = corner.length;
      x = new int[count];
      y = new int[count];
      for (int i = FIRST_CORNER; i < count; i++) {
        x[i] = space.cornerX(corner[i]);
        y[i] = space.cornerY(corner[i]);
      }
      x[START] = ends.startX();
      y[START] = ends.startY();
      x[GOAL] = ends.goalX();
      y[GOAL] = ends.goalY();
      parent = new int[count];
      reached = new boolean[count];
    }

    Plan run() {
      queue.add(new Candidate(distanceMm(START, GOAL), 0, START, NONE));
      while (!queue.isEmpty()) {
        Candidate next = queue.remove();
        if (reached[next.node()] || !isOpen(next)) {
          continue;
        }
        reached[next.node()] = true;
        parent[next.node()] = next.parent();
        if (next.node() == GOAL) {
          return new Plan.Found(path());
        }
        expand(next);
      }
      return new Plan.NoPath();
    }

    private boolean isOpen(Candidate way) {
      int from = way.parent();
      int to = way.node();
      return from == NONE || space.sees(x[from], y[from], x[to], y[to]);
    }

    private void expand(Candidate from) {
      int node = from.node();
      for (int to = GOAL; to < x.length; to++) {
        if (!reached[to] && isTangent(node, to)) {
          double lengthMm = from.lengthMm() + distanceMm(node, to);
          queue.add(new Candidate(lengthMm + distanceMm(to, GOAL), lengthMm, to, node));
        }
      }
    }

    private boolean isTangent(int a, int b) {
      return (a < FIRST_CORNER || space.isTangent(x[b], y[b], corner[a]))
          && (b < FIRST_CORNER || space.isTangent(x[a], y[a], corner[b]));
    }

    private double distanceMm(int a, int b) {
      double dx = (double) x[a] - x[b];
      double dy = (double) y[a] - y[b];
      return StrictMath.sqrt(dx * dx + dy * dy);
    }

    private Path path() {
      List<Point> points = new ArrayList<>();
      points.add(new Point(x[GOAL], y[GOAL]));
      for (int node = parent[GOAL]; node != NONE; node = parent[node]) {
        Point point = new Point(x[node], y[node]);
        // An end on a corner and the corner are two nodes.
        if (node == START || !point.equals(points.get(points.size() - 1))) {
          points.add(point);
        }
      }
      Collections.reverse(points);
      return new Path(points);
    }
  }
}
