package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.barrier.BarrierMessage.Arrival;
import org.starl.primitives.barrier.BarrierMessage.Here;
import org.starl.primitives.chaos.SentMessages;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/** One member among messages of the others: each effect at once, with no repetition behind it. */
class BarrierAnswersTest {

  private static final Instance SOURCE = Instance.of("barrier", "b");
  private static final ProcessId B1 = ProcessId.first(new RobotId("b1"), 1);
  private static final ProcessId B2 = ProcessId.first(new RobotId("b2"), 1);
  private static final ProcessId B3 = ProcessId.first(new RobotId("b3"), 1);
  private static final BarrierSettings SETTINGS = BarrierSettings.DEFAULT;
  private static final long MS = 1_000_000;

  private final OutcomesFormat format = new OutcomesFormat(new TreeSet<>(List.of(B1, B2, B3)));
  private SentMessages sent = new SentMessages();
  private BarrierProtocol protocol = started(B1);

  @Property(tries = 100)
  void aMessageOfAnotherGenerationIsAnswered(
      @ForAll @LongRange(max = 3) long decided,
      @ForAll @LongRange(min = 1, max = 6) long generation,
      @ForAll boolean hasArrived) {
    sent = new SentMessages();
    protocol = started(B1);
    if (decided > 0) {
      decide(decided);
    }
    for (long told = 0; told < decided; told++) {
      protocol.arrive(0);
    }
    if (hasArrived) {
      protocol.arrive(0);
    }
    sent.take();

    List<Object> expected = new ArrayList<>();
    if (generation <= decided) {
      expected.add(outcomes(decided));
    }
    protocol.received(new Here(B3, generation, false, generation), 0);
    assertThat(sent.take()).isEqualTo(expected);

    if (generation > decided + 1) {
      expected.add(new Query(decided));
    }
    if (generation > decided) {
      expected.add(new Here(B1, decided + 1, hasArrived, generation));
    }
    protocol.received(new Arrival(B2, generation), 0);
    assertThat(sent.take()).isEqualTo(expected);
  }

  @Test
  void aRestartedRobotAnswersWithTheOutcomesThatItHasStored() {
    decide(2);
    protocol = started(ProcessId.first(B1.robot(), 2));
    sent.take();
    protocol.received(new Arrival(B2, 1), 0);
    assertThat(sent.take()).containsExactly(outcomes(2));
  }

  @Test
  void anArrivalIsRepeatedUntilTheOtherHasArrivedAndHasAcknowledgedIt() {
    protocol.arrive(0);
    assertThat(sent.take()).containsExactly(new Arrival(B1, 1), new Arrival(B1, 1));
    protocol.received(new Here(B2, 1, true, 1), 0);
    protocol.timer(SETTINGS.repeatMs() * MS);
    assertThat(sent.take()).as("to b3 alone").containsExactly(new Arrival(B1, 1));
    protocol.received(new Here(B3, 1, false, 1), SETTINGS.repeatMs() * MS);
    protocol.timer(2 * SETTINGS.repeatMs() * MS);
    assertThat(sent.take()).as("b3 has not arrived").containsExactly(new Arrival(B1, 1));
  }

  @Test
  void anAcknowledgementOfAnEarlierArrivalDoesNotCount() {
    decide(1);
    protocol.arrive(0);
    protocol.arrive(0);
    sent.take();
    protocol.received(new Here(B2, 2, true, 1), 0);
    protocol.timer(SETTINGS.repeatMs() * MS);
    assertThat(sent.take()).containsExactly(new Arrival(B1, 2), new Arrival(B1, 2));
  }

  @Test
  void theFirstInOrderProposesWithTheLastArrival() {
    protocol.arrive(0);
    protocol.received(new Arrival(B2, 1), 0);
    assertThat(sent.take()).noneMatch(Prepare.class::isInstance);
    protocol.received(new Here(B3, 1, true, 1), 0);
    assertThat(sent.take()).hasAtLeastOneElementOfType(Prepare.class);
  }

  @Test
  void theFirstInOrderProposesWhenItArrivesLast() {
    protocol.received(new Arrival(B2, 1), 0);
    protocol.received(new Arrival(B3, 1), 0);
    sent.take();
    protocol.arrive(0);
    assertThat(sent.take()).hasAtLeastOneElementOfType(Prepare.class);
  }

  /** In the first one it arrives before the last, in the second it is the last. */
  @Test
  void inEachGenerationTheSecondInOrderWaitsForItsTurn() {
    protocol = started(B2);
    protocol.arrive(0);
    protocol.received(new Arrival(B1, 1), 0);
    protocol.received(new Arrival(B3, 1), 0);
    assertThat(sent.take()).noneMatch(Prepare.class::isInstance);
    decide(1);
    protocol.received(new Arrival(B1, 2), 10_000 * MS);
    protocol.received(new Arrival(B3, 2), 10_000 * MS);
    protocol.arrive(10_000 * MS);
    assertThat(sent.take()).noneMatch(Prepare.class::isInstance);
  }

  /** Between generations silence is no sign of a crash. */
  @Test
  void theSilenceOfAMemberCountsFromTheArrival() {
    protocol.arrive(0);
    decide(1);
    long laterNs = 10 * SETTINGS.silenceMs() * MS;
    protocol.arrive(laterNs);
    protocol.timer(laterNs + SETTINGS.silenceMs() * MS - 1);
    assertThat(sent.take()).noneMatch(Prepare.class::isInstance);
    protocol.timer(laterNs + SETTINGS.silenceMs() * MS);
    assertThat(sent.take()).hasAtLeastOneElementOfType(Prepare.class);
  }

  @Test
  void theSilenceOfAMemberThatHasArrivedDoesNotCount() {
    protocol.arrive(0);
    protocol.received(new Arrival(B2, 1), 100 * MS);
    long silentNs = SETTINGS.silenceMs() * MS;
    protocol.received(new Here(B3, 1, false, 1), silentNs);
    protocol.timer(silentNs);
    assertThat(protocol.wakeAtNs()).isEqualTo(silentNs + SETTINGS.repeatMs() * MS);
  }

  @Test
  void aRobotThatWasToldUnknownWaitsForNothing() {
    protocol.arrive(0);
    assertThat(protocol.waitsFor(SOURCE).on()).containsExactly(B2.robot(), B3.robot());
    for (int deadlines = 0; deadlines < 2; deadlines++) {
      assertThat(protocol.outcome().isTold()).isFalse();
      protocol.timer((deadlines + 1) * SETTINGS.deadlineMs() * MS);
    }
    assertThat(protocol.outcome()).isEqualTo(new BarrierOutcome.Unknown(1));
    assertThat(protocol.waitsFor(SOURCE)).isNull();
    assertThat(protocol.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void whenAllHaveArrivedItWaitsForVotes() {
    protocol.arrive(0);
    protocol.received(new Arrival(B2, 1), 0);
    protocol.received(new Arrival(B3, 1), 0);
    assertThat(protocol.waitsFor(SOURCE).what()).contains("majority");
  }

  private BarrierProtocol started(ProcessId me) {
    return new BarrierProtocol(
        me,
        new TreeSet<>(List.of(B1, B2, B3)),
        SETTINGS,
        new Rng(1),
        sent,
        (to, message) -> sent.add(message),
        0);
  }

  private void decide(long generation) {
    protocol.received(B2.robot(), outcomes(generation), 0);
  }

  private SynodMessage outcomes(long generation) {
    return new Decided(generation, format.toValue(Outcomes.ALL_PASSED));
  }
}
