package org.starl.primitives.paths;

/**
 * Plans a path for a body on a floor with obstacles. Stateless and thread-safe: equal tasks give
 * equal plans. Planning takes long, so an app runs it outside its strand:
 *
 * <pre>{@code
 * PlanTask task = PlanTask.of(gvh, goal, bounds, clearanceMm);
 * Computation<Plan> plan = gvh.plat.compute(() -> planner.plan(task));
 * await(plan::isDone);
 * }</pre>
 */
public interface PathPlanner {

  /** Plans a path, or says why there is none. */
  Plan plan(PlanTask task);
}
