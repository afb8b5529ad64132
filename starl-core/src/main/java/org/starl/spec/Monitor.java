package org.starl.spec;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * One executable specification, over one run. It sees every event in order, has no side effect, and
 * needs nothing but the events: it works alike on a live run and on a recorded one. Safety is checked
 * whatever the world does; progress is owed while {@link Circumstances#isFair}.
 */
public interface Monitor {

  /** The lemmas that this monitor checks, by their names in the paper, in PVS or in the models. */
  List<String> lemmas();

  /** What one of the {@link #lemmas} says, in a sentence for people; empty where nobody wrote it. */
  default String says(String lemma) {
    return "";
  }

  /**
   * Those that are to watch a run that this one watches: with {@code MutexSpec}, {@code
   * MutexConformance}.
   */
  default List<Monitor> companions() {
    return List.of();
  }

  /**
   * Those {@link #lemmas} that are about each robot by itself, or forbid what several do, so that over
   * the events of one robot alone, from a start of its program on and without those of bodies, they
   * are violated only where they are over everybody's. A deployed robot watches them as it runs.
   */
  default List<String> ownLemmas() {
    return List.of();
  }

  /** Sees the next event. */
  void observe(TraceEvent event, Report report);

  /** Sees the end of the run. */
  default void finish(long endNs, Report report) {}

  /** Takes what a monitor finds. */
  interface Report {

    /** {@code lemma} was looked at once more, and held unless a violation is reported as well. */
    void checked(String lemma);

    /**
     * {@code lemma} does not hold.
     *
     * @param robots those involved, in order
     * @param detail one line with the values
     */
    void violated(String lemma, long timeNs, List<RobotId> robots, String detail);
  }
}
