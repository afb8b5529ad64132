// Longer than 500 lines because it asks one voter all that the messages of others can make it do.
package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.primitives.ledger.Seen.A;
import static org.starl.primitives.ledger.Seen.B;
import static org.starl.primitives.ledger.Seen.PA;
import static org.starl.primitives.ledger.Seen.PB;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.LongStream;
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
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.time.Time;

/** One voter among messages of the others: each effect at once, with no repetition behind it. */
class LedgerAnswersTest {

  private static final RobotId C = new RobotId("c");
  private static final ProcessId PC = ProcessId.first(C, 1);

  private final SentMessages sent = new SentMessages();
  private final List<Long> stored = new ArrayList<>();
  private final List<String> told = new ArrayList<>();
  private LedgerState before = new LedgerState();
  private final LedgerProtocol protocol = protocol();

  LedgerAnswersTest() {
    sent.take();
    told.clear();
  }

  private LedgerProtocol protocol() {
    return protocol(PA);
  }

  private LedgerProtocol protocol(ProcessId of) {
    return new LedgerProtocol(
        of,
        Participants.of(A, B),
        Participants.of(A, B, C),
        LedgerSettings.DEFAULT,
        new Rng(1),
        sent,
        new Port(),
        0);
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
    protocol.received(new Part(PB, 1, 0, 1, Value.of(bytes(later))), 0);
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
    protocol.received(new Part(PB, 1, 0, 1, Value.of(bytes(later))), 0);
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
    protocol.received(part(PC, 1, 0, older, half), 0);
    protocol.received(part(PB, 2, 1, newer, half), 0);
    assertThat(protocol.state().number()).isEqualTo(2);
  }

  private static byte[] state(long number) {
    LedgerState state = new LedgerState();
    for (long decree = 1; decree <= number; decree++) {
      state.next(decree, Value.EMPTY);
    }
    return bytes(state);
  }

  private static byte[] bytes(LedgerState state) {
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

  /** Such parts come from a program of another version, or from one without a key. */
  @Test
  void partsThatMakeNoSenseAreRefusedAndLaterOnesTaken() {
    byte[] state = state(2);
    byte[] longer = Arrays.copyOf(state, state.length + 1);
    protocol.received(new Part(PB, 2, 0, 1, Value.of(new byte[] {1, 2})), 0);
    protocol.received(new Part(PB, 2, 0, 1, Value.of(longer)), 0);
    protocol.received(new Part(PB, 3, 0, 1, Value.of(state)), 0);
    assertThat(told).containsExactly("refused b", "refused b", "refused b");
    protocol.received(new Part(PB, 4, 0, 2, Value.EMPTY), 0);
    protocol.received(new Part(PB, 4, 2, 3, Value.EMPTY), 0);
    assertThat(protocol.state().number()).isZero();
    protocol.received(new Part(PB, 4, 0, 1, Value.of(state(4))), 0);
    assertThat(protocol.state().number()).isEqualTo(4);
  }

  @Test
  void aStateWithATaskThatTheAppCannotReadIsRefused() {
    for (int bytes : new int[] {13, 12}) {
      LedgerState later = new LedgerState();
      later.next(2, Value.EMPTY);
      later.apply(new LedgerEntry.Add(new TaskId("t", 1), Value.of(new byte[bytes])));
      protocol.received(new Part(PB, 2, 0, 1, Value.of(bytes(later))), 0);
    }
    assertThat(told).containsExactly("refused b", "installed 2 1");
  }

  /** The robot with the newer state crashes before it has sent all of it. */
  @Test
  void partsThatDoNotComeAreNotWaitedFor() {
    byte[] newest = state(3);
    int half = newest.length / 2;
    long laterNs = LedgerSettings.DEFAULT.beaconMs() * Time.NS_PER_MS;
    protocol.received(part(PB, 3, 0, newest, half), 0);
    protocol.received(new Part(PB, 2, 0, 1, Value.of(state(2))), laterNs - 1);
    assertThat(protocol.state().number()).isZero();
    protocol.received(new Part(PB, 2, 0, 1, Value.of(state(2))), laterNs);
    assertThat(protocol.state().number()).isEqualTo(2);
  }

  private void decrees(int count) {
    for (long number = 1; number <= count; number++) {
      decree(number, 0);
    }
    sent.take();
  }

  private List<Object> answerTo(long known) {
    sent.take();
    protocol.received(new Here(PB, known, true), 0);
    return sent.take();
  }

  private static List<Long> numbers(List<Object> messages) {
    return messages.stream().map(each -> each instanceof Decided its ? its.number() : -1L).toList();
  }

  @Test
  void aRobotThatAsksGetsTheDecreesThatItLacks() {
    decrees(3);
    assertThat(numbers(answerTo(1))).containsExactly(2L, 3L);
    assertThat(answerTo(3)).isEmpty();
    protocol.received(new Here(PB, 1, false), 0);
    assertThat(sent.take()).as("it does not ask").isEmpty();
  }

  @Test
  void anAnswerHasSixteenDecreesAtMost() {
    decrees(40);
    assertThat(numbers(answerTo(4))).containsExactlyElementsOf(range(5, 20));
    assertThat(numbers(answerTo(24))).containsExactlyElementsOf(range(25, 40));
  }

  private static List<Long> range(long from, long last) {
    return LongStream.rangeClosed(from, last).boxed().toList();
  }

  @Test
  void aRobotThatIsFartherBehindThanDecreesAreKeptGetsTheState() {
    decrees(65);
    assertThat(numbers(answerTo(1))).containsExactlyElementsOf(range(2, 17));
    assertThat(answerTo(0)).singleElement().isInstanceOf(Part.class);
  }

  /** Each part fits a datagram, and all of them are the state. */
  @Test
  void aLargeStateIsSentInParts() {
    before = large();
    List<Part> parts = new ArrayList<>();
    sent.take();
    LedgerProtocol full = protocol();
    sent.take();
    full.received(new Here(PB, 1, true), 0);
    sent.take().forEach(each -> parts.add((Part) each));
    assertThat(parts).hasSizeGreaterThan(2);
    assertThat(parts).allMatch(part -> part.bytes().length() <= 900 && part.number() == 7);
    Collections.reverse(parts);
    parts.forEach(part -> protocol.received(part, 0));
    assertThat(protocol.state().number()).isEqualTo(7);
    assertThat(protocol.state().tasks()).isEqualTo(before.tasks());
  }

  private static LedgerState large() {
    LedgerState state = new LedgerState();
    state.next(7, Value.EMPTY);
    for (int number = 1; number <= 20; number++) {
      state.apply(new LedgerEntry.Add(new TaskId("t", number), Value.of(new byte[100])));
    }
    return state;
  }

  @Test
  void whatWasKeptBeforeAStateIsNotToldAfterIt() {
    decrees(2);
    protocol.received(new Part(PB, 9, 0, 1, Value.of(state(9))), 0);
    assertThat(answerTo(1)).singleElement().isInstanceOf(Part.class);
  }

  @Test
  void decreesThatCameEarlyFollowAStateAndADecree() {
    decree(3, 0);
    decree(6, 0);
    assertThat(protocol.state().number()).isZero();
    protocol.received(new Part(PB, 2, 0, 1, Value.of(state(2))), 0);
    assertThat(protocol.state().number()).isEqualTo(3);
    assertThat(told).containsExactly("installed 2 0", "applied 3 0 0");
    decree(5, 0);
    assertThat(protocol.state().number()).isEqualTo(3);
    decree(4, 0);
    assertThat(protocol.state().number()).isEqualTo(6);
  }

  @Test
  void aRobotGoesOnFromItsStoredState() {
    before = large();
    before.apply(new LedgerEntry.Start(PA));
    before.apply(new LedgerEntry.Start(PB));
    before.apply(new LedgerEntry.Claim(new TaskId("t", 1), 1, PB));
    LedgerProtocol again = protocol();
    assertThat(told).containsExactly("installed 7 20");
    assertThat(again.isReady()).isTrue();
    sent.take();
    again.received(B, new Prepare(7, new Ballot(9, PB), Value.EMPTY), 0);
    assertThat(sent.take()).as("the decree is known").contains(new Decided(7, Value.EMPTY));
    again.timer(10 * LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS);
    assertThat(again.isSilent(B)).as("watched since the start").isTrue();
    assertThat(again.isSilent(A)).isFalse();
  }

  /** One that is not yet in the log says so at once. */
  @Test
  void aProgramBeginsWithItsStart() {
    protocol();
    Value start = Value.write(out -> LedgerEntry.LIST.write(List.of(Seen.START_A), out));
    assertThat(sent.take())
        .anySatisfy(each ->
            assertThat(each)
                .isInstanceOfSatisfying(
                    Prepare.class, ask -> assertThat(ask.wish()).isEqualTo(start)));
  }

  @Test
  void aCallIsSettledAtOnceByWhatIsKnown() {
    decree(1, 0, Seen.START_A, Seen.START_B, Seen.ADD, new LedgerEntry.Claim(Seen.T, 1, PB));
    told.clear();
    LedgerCall late = protocol.want(Seen.CLAIM_A, 0);
    assertThat(late.outcome()).isEqualTo(LedgerOutcome.LATE);
    assertThat(told).containsExactly("LATE Claim");
    assertThat(protocol.want(Seen.ADD, 0).outcome()).isEqualTo(LedgerOutcome.DONE);
  }

  @Test
  void aStateThatIsTakenOverSettlesCalls() {
    decree(1, 0, Seen.START_A);
    LedgerCall call = protocol.want(Seen.ADD, 0);
    assertThat(call.isDone()).isFalse();
    LedgerState later = new LedgerState();
    later.next(5, Value.EMPTY);
    List.of(Seen.START_A, Seen.ADD).forEach(later::apply);
    protocol.received(new Part(PB, 5, 0, 1, Value.of(bytes(later))), 0);
    assertThat(call.outcome()).isEqualTo(LedgerOutcome.DONE);
    assertThat(told).endsWith("installed 5 1", "DONE Add");
  }

  @Test
  void aCallEndsAtItsDeadline() {
    decree(1, 0, Seen.START_A);
    long deadlineNs = LedgerSettings.DEFAULT.deadlineMs() * Time.NS_PER_MS;
    LedgerCall call = protocol.want(Seen.ADD, 5);
    protocol.timer(deadlineNs + 4);
    assertThat(call.isDone()).isFalse();
    protocol.timer(deadlineNs + 5);
    assertThat(call.outcome()).isEqualTo(LedgerOutcome.UNKNOWN);
  }

  /** The robot is not asked twice within 200 ms, nor while parts of a state are on their way. */
  @Test
  void questionsAreNotSentTooOften() {
    long ms = Time.NS_PER_MS;
    assertThat(asks(0)).isTrue();
    assertThat(asks(200 * ms - 1)).isFalse();
    assertThat(asks(200 * ms)).isTrue();
    protocol.received(new Part(PB, 9, 0, 2, Value.EMPTY), 300 * ms);
    assertThat(asks(300 * ms + LedgerSettings.DEFAULT.beaconMs() * ms - 1)).isFalse();
    assertThat(asks(300 * ms + LedgerSettings.DEFAULT.beaconMs() * ms)).isTrue();
  }

  private boolean asks(long nowNs) {
    sent.take();
    protocol.received(new Here(PB, 9, false), nowNs);
    return sent.take().contains(new Here(PA, 0, true));
  }

  /** The acceptor's record tells of later decrees than the state: it would vote for what it forgot. */
  @Test
  void aProgramWhoseStateIsLostDoesNotStart() {
    decree(1, 0);
    before = state(protocol);
    assertThat(protocol().state().number()).isEqualTo(1);
    before = new LedgerState();
    assertThatThrownBy(this::protocol)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("it ends at decree 0, but the acceptor's record at 1");
  }

  private static LedgerState state(LedgerProtocol of) {
    return LedgerState.SHAPE.read(new WireReader(bytes(of.state())));
  }

  @Test
  void onlyVotersWatchHolders() {
    decree(1, 0, Seen.START_A, Seen.START_B, Seen.ADD);
    decree(2, 0, new LedgerEntry.Claim(Seen.T, 1, PB));
    before = state(protocol);
    LedgerProtocol third = protocol(PC);
    third.timer(100 * LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS);
    assertThat(third.isSilent(B)).isFalse();
  }

  /** Every beacon asks another voter. */
  @Test
  void beaconsAskTheVotersInTurn() {
    LedgerProtocol third = protocol(PC);
    long periodNs = LedgerSettings.DEFAULT.beaconMs() * Time.NS_PER_MS;
    for (int beacon = 0; beacon < 4; beacon++) {
      sent.take();
      third.timer(beacon * periodNs);
      assertThat(sent.take())
          .filteredOn(Here.class::isInstance)
          .containsExactly(new Here(PC, 0, beacon % 2 == 0), new Here(PC, 0, beacon % 2 == 1));
      third.timer((beacon + 1) * periodNs - 1);
      assertThat(sent.take()).noneMatch(Here.class::isInstance);
    }
  }

  private List<Value> wishes() {
    List<Value> wishes = new ArrayList<>();
    for (Object each : sent.take()) {
      if (each instanceof Prepare ask) {
        wishes.add(ask.wish());
      }
    }
    return wishes;
  }

  /** By the timer alone: nothing else need happen. */
  @Test
  void theEndOfASilentHoldersClaimIsProposedUnlessItIsBegun() {
    long leaseNs = LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS;
    Value free = Value.write(out -> LedgerEntry.LIST.write(List.of(Seen.FREE), out));
    decree(1, 0, Seen.START_A, Seen.START_B, Seen.ADD);
    decree(2, 0, new LedgerEntry.Claim(Seen.T, 1, PB));
    sent.take();
    protocol.timer(leaseNs - 1);
    assertThat(wishes()).isEmpty();
    protocol.timer(leaseNs);
    assertThat(wishes()).isNotEmpty().containsOnly(free);
    decree(3, leaseNs, new LedgerEntry.Begin(Seen.T, 1, PB));
    sent.take();
    protocol.timer(4 * leaseNs);
    assertThat(wishes()).isEmpty();
  }

  /** A later voter suspects half a second later than the one before it. */
  @Test
  void votersSuspectOneAfterTheOther() {
    decree(1, 0, new LedgerEntry.Start(PC), Seen.ADD);
    decree(2, 0, new LedgerEntry.Claim(Seen.T, 1, PC));
    LedgerProtocol second = protocol(PB);
    second.received(new Part(PA, 2, 0, 1, Value.of(bytes(protocol.state()))), 0);
    long leaseNs = LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS;
    long turnNs = 500 * Time.NS_PER_MS;
    protocol.timer(leaseNs - 1);
    assertThat(protocol.isSilent(C)).isFalse();
    protocol.timer(leaseNs);
    assertThat(protocol.isSilent(C)).isTrue();
    second.timer(leaseNs + turnNs - 1);
    assertThat(second.isSilent(C)).isFalse();
    second.timer(leaseNs + turnNs);
    assertThat(second.isSilent(C)).isTrue();
  }

  /** A promise with the wishes of all acceptors must fit a datagram. */
  @Test
  void aWishHasTheFirstEntriesThatFit() {
    decree(1, 0, Seen.START_A);
    for (int i = 1; i <= 3; i++) {
      protocol.want(new LedgerEntry.Add(new TaskId("s" + i, 1), Value.of(new byte[100])), 0);
    }
    sent.take();
    decree(2, 0); // another robot's: the next proposal has all three
    protocol.timer(15 * Time.NS_PER_S);
    List<Prepare> asked = new ArrayList<>();
    for (Object each : sent.take()) {
      if (each instanceof Prepare its) {
        asked.add(its);
      }
    }
    assertThat(asked).isNotEmpty();
    Value wish = asked.get(asked.size() - 1).wish();
    assertThat(wish.length()).isBetween(200, 250);
    assertThat(LedgerProtocol.read(wish)).hasSize(2);
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
      return before;
    }

    @Override
    public void store(LedgerState state) {
      stored.add(state.number());
    }

    @Override
    public void applied(long number, List<LedgerEntry> entries, int tasks) {
      told.add("applied " + number + " " + entries.size() + " " + tasks);
    }

    @Override
    public void installed(long number, int tasks) {
      told.add("installed " + number + " " + tasks);
    }

    @Override
    public void check(Value what) {
      if (what.length() == 13) {
        throw new WireFormatException("a task that the app cannot read");
      }
    }

    @Override
    public void refused(ProcessId from, String what) {
      told.add("refused " + from.robot());
    }

    @Override
    public void told(LedgerEntry entry, LedgerOutcome outcome) {
      told.add(outcome + " " + entry.getClass().getSimpleName());
    }
  }
}
