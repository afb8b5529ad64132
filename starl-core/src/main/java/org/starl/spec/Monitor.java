package org.starl.spec;

import java.util.List;
import java.util.Map;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * An executable specification that checks one run. It sees every event in order, has no side
 * effect, and needs only the events, so it works on a live run as on a recorded one. Safety is
 * always checked; progress is required only while {@link FaultState#isFaultFree}.
 */
public interface Monitor {

  /** The lemmas that this monitor checks, by their names in the paper, in PVS or in the models. */
  List<String> lemmas();

  /**
   * The meaning of one of the {@link #lemmas}, as a sentence for people; empty if there is none.
   */
  default String description(String lemma) {
    return "";
  }

  /**
   * The {@link #lemmas} of progress: something must happen in time. Of the others, which are of
   * safety, a violation stays one, however the run continues.
   */
  default List<String> progressLemmas() {
    return List.of();
  }

  /**
   * Further monitors for every run that this one checks: {@code MutexConformance} with {@code
   * MutexSpec}.
   */
  default List<Monitor> companions() {
    return List.of();
  }

  /**
   * The {@link #lemmas} that one robot can check alone. Checked on the events of one robot, from a
   * start of its program and without events of bodies, they are violated only if they are violated
   * on the events of all robots. A deployed robot checks them while it runs.
   */
  default List<String> perRobotLemmas() {
    return List.of();
  }

  /**
   * The robots of this run of which a lemma is not required, and why: a line for each group of
   * robots. Users see it with the results.
   */
  default List<String> exceptions() {
    return List.of();
  }

  /**
   * The {@link #lemmas} that runs like this one never check, each with the reason: {@code the house
   * has an object}. Of every other lemma that was never checked, users see that.
   */
  default Map<String, String> inapplicable() {
    return Map.of();
  }

  /**
   * The {@link #lemmas} that are not checked any more, each with when and why: {@code bot3 restarts at
   * 12.3 s}. What was checked before counts.
   */
  default Map<String, String> inPart() {
    return Map.of();
  }

  /** Processes the next event. */
  void observe(TraceEvent event, Report report);

  /** Processes the end of the run. */
  default void finish(long endNs, Report report) {}

  /** Receives the results of a monitor. */
  interface Report {

    /** {@code lemma} was checked once more; it held unless a violation is reported as well. */
    void checked(String lemma);

    /**
     * The automaton of a theory took an action.
     *
     * @param theory its name: {@code Mutex_decls}
     * @param action the class of the action
     */
    default void taken(String theory, Class<?> action) {}

    /**
     * A conjunct of an action's guard was evaluated, after those before it were true.
     *
     * @param theory its name: {@code Mutex_decls}
     * @param action the class of the action
     * @param conjunct as in the theory
     */
    default void evaluated(String theory, Class<?> action, String conjunct, boolean holds) {}

    /**
     * {@code lemma} is violated.
     *
     * @param robots the robots involved, in order
     * @param detail one line with the values
     */
    void violated(String lemma, long timeNs, List<RobotId> robots, String detail);

    /** {@code lemma} is violated in a region of the floor, which pictures mark. */
    default void violatedIn(
        Region region, String lemma, long timeNs, List<RobotId> robots, String detail) {
      violated(lemma, timeNs, robots, detail);
    }

    /** {@code lemma} is violated, because its deadline has passed: as {@link #violated}. */
    default void overdue(String lemma, long deadlineNs, List<RobotId> robots, String detail) {
      violated(lemma, deadlineNs, robots, detail);
    }
  }
}
