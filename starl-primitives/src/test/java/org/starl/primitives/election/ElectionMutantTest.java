package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;

/** Elections that are wrong in one place: the specification must see each, or it proves nothing. */
class ElectionMutantTest {

  private static final int SEEDS = 200;

  /** What is wrong, and which lemma must tell. */
  enum Mutant {
    STRATEGYS_WINNER_WITHOUT_DECISION(ElectionSpec.AGREEMENT, NoConsensus::new),
    ANSWER_OF_ANOTHER_TERM(ElectionSpec.SOUNDNESS, AnswerOfAnotherTerm::new),
    NOBODY_EVER_PROPOSES(ElectionSpec.ELECTED, Undecided::new),
    DEADLINE_FORGOTTEN(ElectionSpec.TOLD, NeverTold::new);

    private final String lemma;
    private final Voter.Maker maker;

    Mutant(String lemma, Voter.Maker maker) {
      this.lemma = lemma;
      this.maker = maker;
    }
  }

  /** Takes the strategy's candidate as the leader, without a decision. */
  private static final class NoConsensus extends ElectionProtocol {
    NoConsensus(
        ProcessId me,
        Participants participants,
        ElectionSettings settings,
        Rng rng,
        SynodLink link,
        ElectionPort port,
        long nowNs) {
      super(me, participants, settings, rng, link, port, nowNs);
    }

    @Override
    void propose(ProcessId candidate) {
      decided(term(), candidate);
    }
  }

  /** Takes the leader of any term for that of its own. */
  private static final class AnswerOfAnotherTerm extends ElectionProtocol {
    AnswerOfAnotherTerm(
        ProcessId me,
        Participants participants,
        ElectionSettings settings,
        Rng rng,
        SynodLink link,
        ElectionPort port,
        long nowNs) {
      super(me, participants, settings, rng, link, port, nowNs);
    }

    @Override
    void elected(ElectionMessage.Elected m) {
      decided(Math.max(term(), 1), m.leader());
    }
  }

  /** Listens to its strategy, and does nothing. */
  private static final class Undecided extends ElectionProtocol {
    Undecided(
        ProcessId me,
        Participants participants,
        ElectionSettings settings,
        Rng rng,
        SynodLink link,
        ElectionPort port,
        long nowNs) {
      super(me, participants, settings.withDeadlineMs(1_000_000), rng, link, port, nowNs);
    }

    @Override
    void propose(ProcessId candidate) {
      // Nothing is ever proposed.
    }
  }

  /** Has a deadline later than the one that it was given. */
  private static final class NeverTold extends ElectionProtocol {
    NeverTold(
        ProcessId me,
        Participants participants,
        ElectionSettings settings,
        Rng rng,
        SynodLink link,
        ElectionPort port,
        long nowNs) {
      super(me, participants, settings.withDeadlineMs(1_000_000), rng, link, port, nowNs);
    }
  }

  @ParameterizedTest
  @EnumSource
  void theSpecificationDetectsTheMutant(Mutant mutant) {
    assertSeen(mutant, mutant.lemma);
  }

  @ParameterizedTest
  @EnumSource(names = {"STRATEGYS_WINNER_WITHOUT_DECISION", "ANSWER_OF_ANOTHER_TERM"})
  void theMutantDeviatesFromTheTheory(Mutant mutant) {
    assertSeen(mutant, ElectionAutomaton.ELECTION_DECLS);
  }

  private static void assertSeen(Mutant mutant, String lemma) {
    long seeds = 0;
    SpecReport report;
    do {
      seeds++;
      Convoy convoy = Convoy.drawn(seeds);
      convoy.maker = mutant.maker;
      convoy.live(true);
      report = convoy.finish();
    } while (report.violations(lemma) == 0 && seeds < SEEDS);
    assertThat(report.violations(lemma)).as("%s, seeds 1..%d", mutant, seeds).isPositive();
  }
}
