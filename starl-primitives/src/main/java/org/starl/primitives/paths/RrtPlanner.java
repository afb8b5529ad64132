package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.random.Rng;

/**
 * Finds a path with a rapidly-exploring random tree, as the original StarL's planner does (LaValle,
 * "Rapidly-exploring random trees: a new tool for path planning", 1998), and shortens it by
 * shortcuts. Fast on large floors. The path is not the shortest, and failure is no proof: {@link
 * Plan.GaveUp}.
 *
 * <p>Its random generator depends on the seed alone: equal tasks give equal plans.
 */
public final class RrtPlanner implements PathPlanner {

  private final RrtSettings settings;
  private final long seed;

  public RrtPlanner(RrtSettings settings, long seed) {
    this.settings = settings;
    this.seed = seed;
  }

  @Override
  public Plan plan(PlanTask task) {
    FreeSpace space = FloorPlan.of(task);
    Ends ends = Ends.of(task);
    Plan.Blocked blocked = ends.blockedIn(space);
    return blocked != null ? blocked : new Tree(space, ends).grow();
  }

  /** A tree rooted at the start; the line from each node to its parent is free. */
  private final class Tree {
    private final FreeSpace space;
    private final Ends ends;
    private final Rng rng = new Rng(seed);
    private final int[] x = new int[settings.maxIterations() + 1];
    private final int[] y = new int[settings.maxIterations() + 1];
    private final int[] parent = new int[settings.maxIterations() + 1];
    private int size;

    Tree(FreeSpace space, Ends ends) {
      this.space = space;
      this.ends = ends;
      add(ends.startX(), ends.startY(), -1);
    }

    Plan grow() {
      if (space.sees(ends.startX(), ends.startY(), ends.goalX(), ends.goalY())) {
        return found(0);
      }
      for (int i = 0; i < settings.maxIterations(); i++) {
        boolean toGoal = rng.nextBoolean(settings.goalBias());
        int wantedX = toGoal ? ends.goalX() : draw(space.xMin(), space.xMax());
        int wantedY = toGoal ? ends.goalY() : draw(space.yMin(), space.yMax());
        int newest = growTowards(wantedX, wantedY);
        if (newest >= 0 && isNearGoal(newest)) {
          return found(newest);
        }
      }
      return new Plan.GaveUp();
    }

    private int draw(int least, int most) {
      return (int) rng.nextLong(least, most);
    }

    /** The new node, or -1. */
    private int growTowards(int wantedX, int wantedY) {
      int from = nearest(wantedX, wantedY);
      double dx = (double) wantedX - x[from];
      double dy = (double) wantedY - y[from];
      double distanceMm = StrictMath.sqrt(dx * dx + dy * dy);
      double part = distanceMm > settings.stepMm() ? settings.stepMm() / distanceMm : 1;
      int toX = FreeSpace.whole(x[from] + dx * part);
      int toY = FreeSpace.whole(y[from] + dy * part);
      boolean isNew = toX != x[from] || toY != y[from];
      if (!isNew || !space.isFree(toX, toY) || !space.sees(x[from], y[from], toX, toY)) {
        return -1;
      }
      return add(toX, toY, from);
    }

    private boolean isNearGoal(int node) {
      double dx = (double) ends.goalX() - x[node];
      double dy = (double) ends.goalY() - y[node];
      return dx * dx + dy * dy <= settings.stepMm() * settings.stepMm()
          && space.sees(x[node], y[node], ends.goalX(), ends.goalY());
    }

    private int nearest(int wantedX, int wantedY) {
      int best = 0;
      long bestSquare = Long.MAX_VALUE;
      for (int i = 0; i < size; i++) {
        long dx = (long) wantedX - x[i];
        long dy = (long) wantedY - y[i];
        long square = dx * dx + dy * dy;
        if (square < bestSquare) {
          bestSquare = square;
          best = i;
        }
      }
      return best;
    }

    private int add(int newX, int newY, int from) {
      x[size] = newX;
      y[size] = newY;
      parent[size] = from;
      return size++;
    }

    private Plan found(int last) {
      List<Point> points = new ArrayList<>();
      points.add(new Point(ends.goalX(), ends.goalY()));
      for (int node = last; node >= 0; node = parent[node]) {
        points.add(new Point(x[node], y[node]));
      }
      Collections.reverse(points);
      return new Plan.Found(
          new Path(new Smoother(space, rng).smooth(points, settings.shortcuts())));
    }
  }
}
