package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Vote;

class AcceptorTest {

  private static final RobotId BOT1 = new RobotId("bot1");
  private static final RobotId BOT2 = new RobotId("bot2");
  private static final Ballot LOW = new Ballot(1, ProcessId.first(BOT1, 1));
  private static final Ballot HIGH = new Ballot(1, ProcessId.first(BOT2, 1));
  private static final Value A = Value.of(new byte[] {1});
  private static final Value B = Value.of(new byte[] {2});

  private final List<SynodMessage> answers = new ArrayList<>();
  private final List<byte[]> records = new ArrayList<>();
  private final SynodLink link =
      new SynodLink() {
        @Override
        public byte @Nullable [] record() {
          return null;
        }

        @Override
        public void send(RobotId to, SynodMessage message) {
          answers.add(message);
        }

        @Override
        public void persist(long version, byte[] record) {
          records.add(record);
        }
      };
  private final Acceptor acceptor = new Acceptor(AcceptorRecord.NEW, link);

  @Test
  void aPromiseWaitsUntilItIsFlushed() {
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    assertThat(records).hasSize(1);
    assertThat(answers).isEmpty();
    acceptor.flushed(1);
    assertThat(answers).containsExactly(new Promise(1, LOW, null, List.of()));
  }

  @Test
  void aVoteWaitsUntilItIsFlushed() {
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    acceptor.flushed(1);
    acceptor.accept(BOT1, new Accept(1, LOW, A));
    assertThat(answers).hasSize(1);
    acceptor.flushed(2);
    assertThat(answers).last().isEqualTo(new Accepted(1, LOW));
  }

  @Test
  void aRepeatedQuestionIsWrittenOnceAndAnsweredOnceWhenFlushed() {
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    assertThat(records).hasSize(1);
    assertThat(answers).isEmpty();
    acceptor.flushed(1);
    assertThat(answers).hasSize(1);
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    assertThat(answers).hasSize(2);
    assertThat(records).hasSize(1);
  }

  @Test
  void aLowerBallotIsRefusedWithThePromisedOne() {
    acceptor.prepare(BOT2, new Prepare(1, HIGH, Value.EMPTY));
    acceptor.flushed(1);
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.EMPTY));
    acceptor.accept(BOT1, new Accept(1, LOW, A));
    assertThat(answers).element(1).isEqualTo(new Nack(1, LOW, HIGH));
    assertThat(answers).element(2).isEqualTo(new Nack(1, LOW, HIGH));
  }

  @Test
  void aPromiseWithAVoteHasNoWishes() {
    acceptor.accept(BOT1, new Accept(1, LOW, A));
    acceptor.prepare(BOT2, new Prepare(1, HIGH, B));
    acceptor.flushed(2);
    assertThat(answers).last().isEqualTo(new Promise(1, HIGH, new Vote(LOW, A), List.of()));
  }

  @Test
  void wishesForANumberArePassedOnEvenFromRefusedBallots() {
    acceptor.prepare(BOT2, new Prepare(1, HIGH, B));
    acceptor.prepare(BOT1, new Prepare(1, LOW, A));
    Ballot higher = new Ballot(2, HIGH.proposer());
    acceptor.prepare(BOT2, new Prepare(1, higher, B));
    acceptor.flushed(2);
    assertThat(answers).last().isEqualTo(new Promise(1, higher, null, List.of(B, A)));
  }

  @Test
  void wishesInAPromiseAreBoundedSoThatItFitsADatagram() {
    for (int i = 0; i < 20; i++) {
      RobotId bot = new RobotId("bot" + i);
      Value wish = Value.of(new byte[90]);
      acceptor.prepare(bot, new Prepare(1, new Ballot(i + 1, ProcessId.first(bot, 1)), wish));
    }
    acceptor.flushed(20);
    assertThat(answers).last().satisfies(m -> assertThat(((Promise) m).wishes()).hasSize(4));
  }

  @Test
  void theLengthsOfWishesCountToo() {
    assertThat(wishesPassedOn(198)).isEqualTo(2);
    assertThat(wishesPassedOn(199)).isEqualTo(1);
  }

  /** Of two of this length. */
  private int wishesPassedOn(int length) {
    acceptor.prepare(BOT1, new Prepare(1, LOW, Value.of(new byte[length])));
    byte[] other = new byte[length];
    other[0] = 1;
    acceptor.prepare(BOT2, new Prepare(1, HIGH, Value.of(other)));
    acceptor.flushed(100);
    return ((Promise) answers.get(answers.size() - 1)).wishes().size();
  }

  @Test
  void aDecreeReplacesTheSlotsThatItSettles() {
    acceptor.accept(BOT2, new Accept(3, HIGH, A));
    acceptor.accept(BOT2, new Accept(4, HIGH, A));
    acceptor.decided(new Decided(3, A));
    AcceptorRecord record = AcceptorRecord.fromBytes(records.get(records.size() - 1));
    assertThat(record.decided()).isEqualTo(new Decided(3, A));
    assertThat(record.slots()).containsOnlyKeys(4L);
  }

  @Test
  void valuesOfDifferentBytesDiffer() {
    assertThat(A).isEqualTo(Value.of(A.bytes())).isNotEqualTo(B).isNotEqualTo(A.toString());
  }

  @Test
  void aQuestionAboutADecidedNumberGetsTheLatestDecree() {
    acceptor.decided(new Decided(5, B));
    acceptor.prepare(BOT1, new Prepare(4, LOW, Value.EMPTY));
    acceptor.accept(BOT1, new Accept(5, LOW, A));
    assertThat(answers).containsExactly(new Decided(5, B), new Decided(5, B));
  }

  @Test
  void promisesAndVotesSurviveARestart() {
    acceptor.decided(new Decided(2, B));
    acceptor.accept(BOT2, new Accept(3, HIGH, A));
    answers.clear();
    byte[] lastRecord = records.get(records.size() - 1);
    Acceptor restarted = new Acceptor(AcceptorRecord.fromBytes(lastRecord), link);
    restarted.prepare(BOT1, new Prepare(3, LOW, Value.EMPTY));
    Ballot higher = new Ballot(2, LOW.proposer());
    restarted.prepare(BOT1, new Prepare(3, higher, Value.EMPTY));
    restarted.prepare(BOT1, new Prepare(2, higher, Value.EMPTY));
    restarted.flushed(1);
    assertThat(answers)
        .containsExactly(
            new Nack(3, LOW, HIGH),
            new Decided(2, B),
            new Promise(3, higher, new Vote(HIGH, A), List.of()));
  }
}
