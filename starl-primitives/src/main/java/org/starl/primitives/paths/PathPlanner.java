package org.starl.primitives.paths;

/**
 * Finds a way for a body over a floor with obstacles. Immutable and free of state: equal tasks give
 * equal plans, and any thread may ask. Planning takes long; an app asks off its strand:
 *
 * <pre>{@code
 * PlanTask task = PlanTask.of(gvh, goal, bounds, clearanceMm);
 * Computation<Plan> plan = gvh.plat.compute(() -> planner.plan(task));
 * await(plan::isDone);
 * }</pre>
 */
public interface PathPlanner {

  /** A path, or why there is none. */
  Plan plan(PlanTask task);
}
