package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.chaos.SentMessages;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/** One participant among messages of the others: each effect at once, with no repetition behind it. */
class ElectionAnswersTest {

  private static final Instance SOURCE = Instance.of("election", "e");
  private static final ProcessId E1 = ProcessId.first(new RobotId("e1"), 1);
  private static final ProcessId E2 = ProcessId.first(new RobotId("e2"), 1);
  private static final ProcessId E3 = ProcessId.first(new RobotId("e3"), 1);
  private static final ProcessId E1_AGAIN = ProcessId.first(E1.robot(), 2);
  private static final ProcessId E3_AGAIN = ProcessId.first(E3.robot(), 2);
  private static final ElectionSettings SETTINGS = ElectionSettings.DEFAULT;
  private static final long DELTA_NS = SETTINGS.deltaMs() * 1_000_000;
  private static final long SILENCE_NS = SETTINGS.silenceMs() * 1_000_000;

  private SentMessages sent = new SentMessages();
  private ElectionProtocol protocol = created();

  @Property(tries = 100)
  void aRobotThatKnowsALeaderTellsOneThatIsBehind(
      @ForAll @LongRange(min = 1, max = 3) long known,
      @ForAll @LongRange(min = 1, max = 4) long term,
      @ForAll boolean isCandidacy) {
    sent = new SentMessages();
    protocol = created();
    protocol.received(new Elected(E1, known, E1), 0);
    sent.take();
    protocol.received(isCandidacy ? new Candidacy(E3, term, 7) : new Elected(E3, term, E3), 0);
    boolean isBehind = isCandidacy ? term <= known : term < known;
    assertThat(sent.take()).isEqualTo(isBehind ? List.of(new Elected(E2, known, E1)) : List.of());
    assertThat(protocol.term()).isEqualTo(isCandidacy ? known : Math.max(known, term));
  }

  @Test
  void aRobotThatNeverStoodAnswersNoCandidacy() {
    protocol.received(new Candidacy(E3, 1, 7), 0);
    assertThat(sent.take()).isEmpty();
    assertThat(protocol.term()).isZero();
  }

  @Test
  void aCandidateTellsOneThatIsBehindThatItStands() {
    candidateInTermTwo();
    protocol.received(new Candidacy(E3, 1, 7), 0);
    assertThat(candidacies()).containsExactly(2L);
    protocol.received(new Elected(E3, 1, E3), 0);
    assertThat(candidacies()).containsExactly(2L);
  }

  @Test
  void aCandidacyOfAnEarlierTermDoesNotCountInThisOne() {
    candidateInTermTwo();
    protocol.received(new Candidacy(E3, 1, 7), 0);
    sent.take();
    protocol.received(new Candidacy(E3, 2, 7), 0);
    assertThat(candidacies()).as("e3 is new in this term").containsExactly(2L);
  }

  @Test
  void aCandidateAnswersEachCandidateOfItsTermOnce() {
    protocol.do_election(0);
    sent.take();
    protocol.received(new Candidacy(E3, 1, 7), 0);
    assertThat(candidacies()).containsExactly(1L);
    protocol.received(new Candidacy(E3, 1, 7), 0);
    assertThat(sent.take()).isEmpty();
  }

  @Test
  void aCandidacyOfALaterTermMakesAParticipantStandThere() {
    protocol.do_election(0);
    sent.take();
    protocol.received(new Candidacy(E3, 5, 7), 0);
    assertThat(protocol.term()).isEqualTo(5);
    assertThat(candidacies()).as("to all, and to e3").containsExactly(5L, 5L);
  }

  @Test
  void theRestartOfALeaderBeginsTheNextTerm() {
    candidateInTermTwo();
    assertThat(protocol.leader()).isEqualTo(Leader.NONE);
    assertThat(protocol.term()).isEqualTo(2);
  }

  @Test
  void theRestartOfAnotherRobotBeginsNoTerm() {
    protocol.do_election(0);
    protocol.received(new Elected(E1, 1, E1), 0);
    protocol.received(new Candidacy(E3, 1, 7), 0);
    protocol.received(new Candidacy(E3_AGAIN, 1, 7), 0);
    assertThat(protocol.term()).isEqualTo(1);
  }

  @Test
  void aCandidacyIsRepeatedUntilALeaderIsKnown() {
    protocol.do_election(0);
    assertThat(candidacies()).containsExactly(1L);
    protocol.timer(DELTA_NS);
    assertThat(candidacies()).containsExactly(1L);
    protocol.received(new Elected(E1, 1, E1), DELTA_NS);
    protocol.timer(2 * DELTA_NS);
    assertThat(candidacies()).isEmpty();
  }

  @Test
  void aCandidateThatIsAloneProposesAfterTwoDelays() {
    protocol.do_election(0);
    protocol.timer(2 * DELTA_NS - 1);
    assertThat(prepared()).isEmpty();
    protocol.timer(2 * DELTA_NS);
    assertThat(prepared()).containsOnly(1L);
  }

  @Test
  void theCandidacyOfACrashedRobotIsForgotten() {
    protocol.do_election(0);
    protocol.received(new Candidacy(E3, 1, Long.MAX_VALUE), 0);
    protocol.timer(2 * DELTA_NS);
    assertThat(prepared()).as("e3 has the higher draw").isEmpty();

    protocol = created();
    protocol.do_election(0);
    protocol.received(new Candidacy(E3, 2, Long.MAX_VALUE), 0);
    protocol.received(new Elected(E3_AGAIN, 1, E1), 0);
    protocol.timer(2 * DELTA_NS);
    assertThat(prepared()).containsOnly(2L);
  }

  @Test
  void aCandidateOfALaterTermProposesThereThoughItProposedBefore() {
    protocol.do_election(0);
    protocol.timer(2 * DELTA_NS);
    assertThat(prepared()).containsOnly(1L);
    protocol.received(new Candidacy(E1, 2, Long.MIN_VALUE), 3 * DELTA_NS);
    assertThat(prepared()).isEmpty();
    protocol.timer(5 * DELTA_NS);
    assertThat(prepared()).containsOnly(2L);
  }

  @Test
  void aDecisionIsToldToAll() {
    protocol.chosen(4, ElectionProtocol.toValue(E3));
    assertThat(sent.take()).containsExactly(new Elected(E2, 4, E3));
  }

  @Test
  void aLeaderTellsSoInEachHeartbeat() {
    protocol.received(new Elected(E1, 1, E2), 0);
    sent.take();
    long beatNs = SETTINGS.heartbeatMs() * 1_000_000;
    for (long atNs = beatNs; atNs <= 3 * beatNs; atNs += beatNs) {
      protocol.timer(atNs - 1);
      assertThat(sent.take()).isEmpty();
      protocol.timer(atNs);
      assertThat(sent.take()).containsExactly(new Elected(E2, 1, E2));
    }
  }

  @Test
  void whatAnEarlierProgramOfARobotHasSentIsIgnored() {
    protocol.received(new Candidacy(E3_AGAIN, 1, 7), 0);
    protocol.received(new Elected(E3, 1, E3), 0);
    assertThat(protocol.leader()).isEqualTo(Leader.NONE);
  }

  /** The silence of an earlier term, when nothing was expected of the robot since, counts no more. */
  @Test
  void aLeaderThatReturnsIsNotSuspectedForItsSilenceBetween() {
    protocol.do_election(0);
    protocol.received(new Elected(E1, 1, E1), 0);
    protocol.received(new Elected(E3, 2, E3), SILENCE_NS - 1);
    protocol.received(new Elected(E3, 3, E1), 2 * SILENCE_NS);
    assertThat(protocol.leader()).isEqualTo(new Leader.Name(E1, 3));
    protocol.received(new Candidacy(E3, 4, 7), 3 * SILENCE_NS - 1);
    assertThat(protocol.leader()).isEqualTo(Leader.NONE);
    protocol.received(new Elected(E3, 5, E1), 4 * SILENCE_NS);
    assertThat(protocol.leader()).isEqualTo(new Leader.Name(E1, 5));
  }

  @Test
  void whatItWaitsForIsTold() {
    assertThat(protocol.waitsFor(SOURCE)).isNull();
    protocol.do_election(0);
    assertThat(protocol.waitsFor(SOURCE).what()).contains("no leader yet in term 1");
    protocol.timer(2 * DELTA_NS);
    assertThat(protocol.waitsFor(SOURCE).what()).contains("majority; missing");
    protocol.timer(SETTINGS.deadlineMs() * 1_000_000);
    assertThat(protocol.waitsFor(SOURCE).what()).contains("failed in term 1");
    assertThat(protocol.wakeAtNs()).as("an election that failed").isEqualTo(Long.MAX_VALUE);
    protocol.received(new Elected(E1, 1, E1), 0);
    assertThat(protocol.waitsFor(SOURCE)).isNull();
  }

  /** Leader of term 1 was E1, which has restarted. */
  private void candidateInTermTwo() {
    protocol.do_election(0);
    protocol.received(new Elected(E1, 1, E1), 0);
    protocol.received(new Elected(E1_AGAIN, 1, E1), 0);
    sent.take();
  }

  private List<Long> candidacies() {
    List<Long> terms = new ArrayList<>();
    for (Object message : sent.take()) {
      if (message instanceof Candidacy m) {
        terms.add(m.term());
      }
    }
    return terms;
  }

  private List<Long> prepared() {
    List<Long> terms = new ArrayList<>();
    for (Object message : sent.take()) {
      if (message instanceof Prepare m) {
        terms.add(m.number());
      }
    }
    return terms;
  }

  private ElectionProtocol created() {
    return new ElectionProtocol(
        E2,
        Participants.of(List.of(E1.robot(), E2.robot(), E3.robot())),
        SETTINGS,
        new Rng(1),
        sent,
        new ElectionPort() {
          @Override
          public void send(RobotId to, ElectionMessage message) {
            sent.add(message);
          }

          @Override
          public void broadcast(ElectionMessage message) {
            sent.add(message);
          }

          @Override
          public void candidate(long term) {}
        },
        0);
  }
}
