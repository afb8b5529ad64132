package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.chaos.SentMessages;
import org.starl.random.Rng;

/** One robot of a sequence of decrees among messages of the others. */
class SynodTest {

  private static final RobotId S1 = new RobotId("s1");
  private static final RobotId S2 = new RobotId("s2");
  private static final RobotId S3 = new RobotId("s3");
  private static final ProcessId ME = ProcessId.first(S1, 1);
  private static final Ballot BALLOT = new Ballot(1, ProcessId.first(S2, 1));
  private static final Value A = Value.of(new byte[] {1});
  private static final Value B = Value.of(new byte[] {2});

  private final List<String> told = new ArrayList<>();
  private final SynodListener listener =
      new SynodListener() {
        @Override
        public void chosen(long number, Value value) {
          told.add("chosen " + number);
        }

        @Override
        public void learned(long number, Value value) {
          told.add("learned " + number);
        }

        @Override
        public void rumour(long number) {
          told.add("rumour " + number);
        }
      };
  private SentMessages sent = new SentMessages();
  private Synod synod = created(S1, S2, S3);

  @Property(tries = 50)
  void aQueryIsAnsweredWithALaterDecree(
      @ForAll @LongRange(max = 3) long known, @ForAll @LongRange(max = 3) long number) {
    sent = new SentMessages();
    synod = created(S1, S2, S3);
    if (known > 0) {
      synod.learn(known, A);
    }
    synod.received(S2, new Query(number), 0);
    assertThat(sent.take()).isEqualTo(known > number ? List.of(new Decided(known, A)) : List.of());
  }

  @Test
  void aQueryTellsTheLatestKnownNumber() {
    synod.query(S2);
    synod.learn(4, A);
    synod.queryAll();
    assertThat(sent.take()).containsExactly(new Query(0), new Query(4), new Query(4), new Query(4));
  }

  @Test
  void onlyLaterDecreesAreLearned() {
    synod.learn(4, A);
    synod.learn(4, B);
    synod.received(S2, new Decided(3, B), 0);
    synod.received(S2, new Decided(6, B), 0);
    assertThat(told).containsExactly("learned 4", "learned 6");
    assertThat(synod.latest()).isEqualTo(new Decided(6, B));
    assertThat(created(S1, S2, S3).latest()).as("after a restart").isEqualTo(new Decided(6, B));
  }

  @Test
  void aDecidedNumberCannotBeProposed() {
    assertThatThrownBy(() -> propose(0)).isInstanceOf(IllegalArgumentException.class);
    propose(1);
    synod.learn(4, A);
    assertThatThrownBy(() -> propose(4)).isInstanceOf(IllegalArgumentException.class);
    propose(5);
    assertThat(synod.isProposing()).isTrue();
  }

  @Test
  void aDecreeEndsTheWorkForItsNumberAndForEarlierOnes() {
    propose(4);
    synod.learn(3, A);
    assertThat(synod.isProposing()).isTrue();
    assertThat(synod.unanswered()).containsExactly(S1, S2, S3);
    synod.learn(4, A);
    assertThat(synod.isProposing()).isFalse();
    propose(5);
    synod.learn(6, A);
    assertThat(synod.isProposing()).as("5 is an earlier one").isFalse();
    propose(7);
    synod.stop();
    assertThat(synod.isProposing()).isFalse();
    assertThat(synod.unanswered()).isEmpty();
    assertThat(synod.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void theWorkOfOthersForAnUnknownNumberIsTold() {
    synod.received(S2, new Prepare(1, BALLOT, Value.EMPTY), 0);
    synod.learn(1, A);
    synod.received(S2, new Prepare(1, BALLOT, Value.EMPTY), 0);
    synod.received(S2, new Accept(1, BALLOT, A), 0);
    synod.received(S2, new Accept(2, BALLOT, A), 0);
    assertThat(told).containsExactly("rumour 1", "learned 1", "rumour 2");
  }

  @Test
  void refusalsByAMajorityEndABallot() {
    propose(1);
    Ballot higher = new Ballot(7, BALLOT.proposer());
    synod.received(S2, new Nack(1, new Ballot(1, ME), higher), 0);
    synod.received(S3, new Nack(1, new Ballot(1, ME), higher), 0);
    sent.take();
    synod.timer(synod.wakeAtNs());
    assertThat(sent.take()).contains(new Prepare(1, new Ballot(8, ME), Value.EMPTY));
  }

  @Test
  void anAcceptorAloneDecides() {
    synod = created(S1);
    assertThat(synod.proposerId()).isEqualTo(ME);
    propose(1);
    for (int answers = 0; answers < 4; answers++) {
      for (Object message : sent.take()) {
        synod.received(S1, (SynodMessage) message, 0);
      }
    }
    assertThat(told).containsSubsequence("chosen 1", "learned 1");
    assertThat(synod.latest()).isEqualTo(new Decided(1, A));
  }

  private void propose(long number) {
    synod.propose(number, Value.EMPTY, wishes -> A, 0);
  }

  private Synod created(RobotId... acceptors) {
    Synod created =
        new Synod(
            S1, Participants.of(acceptors), ME, SynodTiming.DEFAULT, new Rng(1), sent, listener);
    created.flushed(1_000); // every write is stable at once
    return created;
  }
}
