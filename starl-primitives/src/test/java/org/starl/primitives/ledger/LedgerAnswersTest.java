package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.ledger.Seen.A;
import static org.starl.primitives.ledger.Seen.B;
import static org.starl.primitives.ledger.Seen.PA;
import static org.starl.primitives.ledger.Seen.PB;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.chaos.SentMessages;
import org.starl.primitives.ledger.LedgerMessage.Here;
import org.starl.primitives.ledger.LedgerMessage.Part;
import org.starl.random.Rng;
import org.starl.shape.WireWriter;
import org.starl.time.Time;

/** One voter among messages of the others: each effect at once, with no repetition behind it. */
class LedgerAnswersTest {

  private static final RobotId C = new RobotId("c");

  private final SentMessages sent = new SentMessages();
  private final List<Long> stored = new ArrayList<>();
  private final LedgerProtocol protocol =
      new LedgerProtocol(
          PA,
          Participants.of(A, B),
          Participants.of(A, B, C),
          LedgerSettings.DEFAULT,
          new Rng(1),
          sent,
          new Port(),
          0);

  LedgerAnswersTest() {
    sent.take();
  }

  @Test
  void aDecisionIsToldToTheWholeGroup() {
    protocol.chosen(1, Value.EMPTY);
    Decided decree = new Decided(1, Value.EMPTY);
    assertThat(sent.take()).as("to b and c").containsExactly(decree, decree);
  }

  @Test
  void aDecreeIsStoredBeforeTheAcceptorForgetsIt() {
    protocol.received(B, new Decided(1, Value.EMPTY), 0);
    assertThat(stored).containsExactly(1L);
  }

  @Test
  void aStateThatIsTakenOverIsStored() {
    LedgerState later = new LedgerState();
    later.next(1, Value.EMPTY);
    byte[] bytes = WireWriter.toBytes(out -> LedgerState.SHAPE.write(later, out));
    protocol.received(new Part(PB, 1, 0, 1, Value.of(bytes)), 0);
    assertThat(protocol.state().number()).isEqualTo(1);
    assertThat(stored).containsExactly(1L);
  }

  @Test
  void theHoldersInAStateThatIsTakenOverAreWatched() {
    LedgerState later = new LedgerState();
    TaskId task = new TaskId("t", 1);
    later.next(1, Value.EMPTY);
    List.of(
            new LedgerEntry.Start(PB),
            new LedgerEntry.Add(task, Value.EMPTY),
            new LedgerEntry.Claim(task, 1, PB))
        .forEach(later::apply);
    byte[] bytes = WireWriter.toBytes(out -> LedgerState.SHAPE.write(later, out));
    protocol.received(new Part(PB, 1, 0, 1, Value.of(bytes)), 0);
    protocol.timer(10 * LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS);
    assertThat(protocol.isSilent(B)).isTrue();
  }

  /** Two robots send their states, in parts that arrive in any order. */
  @Test
  void aPartOfAnOlderStateIsNoPartOfTheNewest() {
    byte[] older = state(1);
    byte[] newer = state(2);
    int half = newer.length / 2;
    protocol.received(part(PB, 2, 0, newer, half), 0);
    protocol.received(part(ProcessId.first(C, 1), 1, 0, older, half), 0);
    protocol.received(part(PB, 2, 1, newer, half), 0);
    assertThat(protocol.state().number()).isEqualTo(2);
  }

  private static byte[] state(long number) {
    LedgerState state = new LedgerState();
    for (long decree = 1; decree <= number; decree++) {
      state.next(decree, Value.EMPTY);
    }
    return WireWriter.toBytes(out -> LedgerState.SHAPE.write(state, out));
  }

  private static Part part(ProcessId from, long number, int index, byte[] state, int half) {
    byte[] bytes =
        index == 0 ? Arrays.copyOf(state, half) : Arrays.copyOfRange(state, half, state.length);
    return new Part(from, number, index, 2, Value.of(bytes));
  }

  @Test
  void theSilenceOfARobotThatHoldsNothingDoesNotCount() {
    TaskId task = new TaskId("t", 1);
    long silentNs = 10 * LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS;
    decree(1, 0, new LedgerEntry.Start(PB), new LedgerEntry.Add(task, Value.EMPTY));
    decree(2, 0, new LedgerEntry.Claim(task, 1, PB));
    decree(3, 0, new LedgerEntry.Free(task, 1));
    decree(4, silentNs, new LedgerEntry.Claim(task, 2, PB));
    assertThat(protocol.isSilent(B)).isFalse();
  }

  @Test
  void aHolderIsWatchedFromItsClaimOn() {
    TaskId task = new TaskId("t", 1);
    decree(1, 0, new LedgerEntry.Start(PB), new LedgerEntry.Add(task, Value.EMPTY));
    decree(2, 0, new LedgerEntry.Claim(task, 1, PB));
    protocol.timer(10 * LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS);
    assertThat(protocol.isSilent(B)).isTrue();
  }

  private void decree(long number, long nowNs, LedgerEntry... entries) {
    Value value = Value.write(out -> LedgerEntry.LIST.write(List.of(entries), out));
    protocol.received(B, new Decided(number, value), nowNs);
  }

  @Test
  void whoWorksForALaterDecreeIsAsked() {
    protocol.received(B, new Prepare(2, new Ballot(1, PB), Value.EMPTY), 0);
    assertThat(sent.take()).contains(new Here(PA, 0, true));
  }

  @Test
  void whoHasTheNextDecreeIsAsked() {
    protocol.received(new Here(PB, 0, false), 0);
    assertThat(sent.take()).doesNotContain(new Here(PA, 0, true));
    protocol.received(new Here(PB, 1, false), 0);
    assertThat(sent.take()).contains(new Here(PA, 0, true));
  }

  @Test
  void whoWorksForTheNextDecreeIsNotAsked() {
    protocol.received(B, new Prepare(1, new Ballot(1, PB), Value.EMPTY), 0);
    assertThat(sent.take()).doesNotContain(new Here(PA, 0, true));
  }

  private final class Port implements LedgerPort {

    @Override
    public void send(RobotId to, LedgerMessage message) {
      sent.add(message);
    }

    @Override
    public void sendReliably(RobotId to, LedgerMessage message) {
      sent.add(message);
    }

    @Override
    public LedgerState stored() {
      return new LedgerState();
    }

    @Override
    public void store(LedgerState state) {
      stored.add(state.number());
    }

    @Override
    public void applied(long number, List<LedgerEntry> entries, int tasks) {}

    @Override
    public void installed(long number, int tasks) {}

    @Override
    public void told(LedgerEntry entry, LedgerOutcome outcome) {}
  }
}
