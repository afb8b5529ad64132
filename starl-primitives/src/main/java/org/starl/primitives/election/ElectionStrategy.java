package org.starl.primitives.election;

import java.util.List;
import org.starl.id.ProcessId;

/**
 * The candidate that a robot proposes as leader, and when: the only difference between the paper's two
 * implementations. The Synod then decides, so no strategy can break agreement; a bad one is slow.
 */
public enum ElectionStrategy {

  /**
   * Each candidate draws a random number. After two message delays the candidate with the highest one is
   * proposed: first by itself, then by the next ones in turn, until there is a decision.
   */
  RANDOM_BALLOT {
    @Override
    Plan plan(Candidates poll, long nowNs) {
      long firstNs = poll.beganNs() + poll.delaysNs(LISTEN);
      if (nowNs < firstNs) {
        return new Wait(firstNs);
      }
      // A candidate that was silent for as long as a decision takes may be gone.
      List<ProcessId> candidates = poll.byDraw(nowNs - poll.delaysNs(DECIDE));
      int rank = candidates.indexOf(poll.me());
      long myTurnNs = firstNs + rank * poll.delaysNs(DECIDE);
      return nowNs < myTurnNs ? new Wait(myTurnNs) : new Propose(candidates.get(0));
    }
  },

  /**
   * The Bully algorithm (Garcia-Molina, "Elections in a distributed computing system", IEEE
   * Transactions on Computers C-31(1), 1982): a candidate that hears of no higher id within two message
   * delays proposes itself. The others wait for that, and then begin again without the silent ones.
   */
  BULLY {
    @Override
    Plan plan(Candidates poll, long nowNs) {
      long roundNs = poll.delaysNs(LISTEN + DECIDE);
      long roundBeganNs = nowNs - (nowNs - poll.beganNs()) % roundNs;
      long listenedNs = roundBeganNs + poll.delaysNs(LISTEN);
      if (nowNs < listenedNs) {
        return new Wait(listenedNs);
      }
      return poll.hasHigherThanMe(roundBeganNs)
          ? new Wait(roundBeganNs + roundNs)
          : new Propose(poll.me());
    }
  };

  /** Message delays until all candidates know each other. */
  static final int LISTEN = 2;

  /** Message delays from a proposal until other robots know the decision, plus one. */
  static final int DECIDE = 6;

  /** The plan now. It is asked again at the end of a {@link Wait}. */
  abstract Plan plan(Candidates poll, long nowNs);

  sealed interface Plan {}

  record Propose(ProcessId candidate) implements Plan {}

  /**
   * @param untilNs later than now
   */
  record Wait(long untilNs) implements Plan {}
}
