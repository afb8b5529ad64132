package org.starl.primitives.election;

import java.util.List;
import org.starl.id.ProcessId;

/**
 * Whom a robot proposes as leader, and when: all that the paper's two implementations differ in. What
 * is proposed is then decided by the Synod, so no strategy can break agreement; a bad one is slow.
 */
public enum ElectionStrategy {

  /**
   * Each candidate draws a lot. After two message delays the highest is proposed: by its owner first,
   * and by the next ones in turn should nothing come of it.
   */
  RANDOM_BALLOT {
    @Override
    Plan plan(Poll poll, long nowNs) {
      long firstNs = poll.beganNs() + poll.delaysNs(LISTEN);
      if (nowNs < firstNs) {
        return new Wait(firstNs);
      }
      // Who has said nothing for as long as a decision takes may be gone.
      List<ProcessId> candidates = poll.byDraw(nowNs - poll.delaysNs(DECIDE));
      int rank = candidates.indexOf(poll.me());
      long myTurnNs = firstNs + rank * poll.delaysNs(DECIDE);
      return nowNs < myTurnNs ? new Wait(myTurnNs) : new Propose(candidates.get(0));
    }
  },

  /**
   * The Bully algorithm (Garcia-Molina, "Elections in a distributed computing system", IEEE
   * Transactions on Computers C-31(1), 1982): who hears of no higher id within two message delays
   * proposes itself; everybody else waits for that, and begins again without those who were silent.
   */
  BULLY {
    @Override
    Plan plan(Poll poll, long nowNs) {
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

  /** Message delays until all candidates have heard of each other. */
  private static final int LISTEN = 2;

  /** Message delays from a proposal until others know the decision, and one to spare. */
  private static final int DECIDE = 6;

  /** What to do now; asked once, and again when that time has come. */
  abstract Plan plan(Poll poll, long nowNs);

  sealed interface Plan {}

  record Propose(ProcessId candidate) implements Plan {}

  /**
   * @param untilNs later than now
   */
  record Wait(long untilNs) implements Plan {}
}
