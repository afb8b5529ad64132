package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_S;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.comms.Reliability;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.workload.MailFact.Care;
import org.starl.workload.MailFact.Mailed;
import org.starl.workload.MessagesClient.Letter;

/** The specification on handwritten traces: letters of bot0 to bot1, within 5 s; plain ones 1 s. */
class MessagesSpecTest {

  private static final RobotId SENDER = new RobotId("bot0");
  private static final RobotId RECEIVER = new RobotId("bot1");
  private static final Instance LETTERS = Instance.of("mail", "letters");

  private final Monitors monitors = new Monitors(List.of(new MessagesSpec(5 * NS_PER_S, NS_PER_S)));

  @BeforeEach
  void bothAreThere() {
    for (RobotId robot : List.of(SENDER, RECEIVER)) {
      monitors.observe(new TraceEvent.Joined(0, robot, new Pose(0, 0, 0), 165));
      act(0, robot, new MailFact.Opened(LETTERS));
    }
  }

  private void act(long atS, RobotId robot, MailFact fact) {
    monitors.observe(Action.of(atS * NS_PER_S, robot, MailFact.SOURCE, MailFact.SHAPE, fact));
  }

  private void send(long atS, int boot, int number, Care care) {
    act(atS, SENDER, new Mailed(Optional.of(RECEIVER), LETTERS, boot, number, care));
  }

  private void handle(long atS, int boot, int number) {
    act(atS, RECEIVER, new MailFact.Handled(SENDER, LETTERS, boot, number, 6 + number, 6 + number));
  }

  private void transmit(long atNs) {
    transmit(atNs, 1);
  }

  private void transmit(long atNs, int number) {
    Letter letter = new Letter(1, number, 7);
    monitors.observe(
        new TraceEvent.Sent(atNs, SENDER, "bot1", LETTERS, 3 + number, 60, Letter.SHAPE, letter));
  }

  private void fault(long atS, RobotId robot, String name) {
    fault(atS, robot, name, "");
  }

  private void fault(long atS, RobotId robot, String name, String effect) {
    monitors.observe(new TraceEvent.Fault(atS * NS_PER_S, robot, name, effect, ""));
  }

  /** The results so far: any event shows the time. */
  private SpecReport at(long atS) {
    monitors.observe(
        Action.of(atS * NS_PER_S, SENDER, Instance.APP, Note.SHAPE, new Note("any", List.of())));
    return monitors.report();
  }

  @Test
  void aLetterThatIsHandledOnceAndToldDeliveredHolds() {
    send(1, 1, 1, Care.DEFAULT);
    transmit(NS_PER_S);
    handle(2, 1, 1);
    act(3, SENDER, new MailFact.Delivered(RECEIVER, 1, 1));
    send(11, 1, 2, Care.NONE);
    handle(12, 1, 2);
    assertThat(at(99).holds()).as("%s", monitors.report()).isTrue();
    assertThat(monitors.report().lemmas())
        .allSatisfy(lemma -> assertThat(monitors.report().checks(lemma)).isPositive());
  }

  @Test
  void aLetterThatWasNotSentViolatesGenuine() {
    handle(2, 1, 1);
    assertThat(at(3).violations("messages.Genuine")).isEqualTo(1);
  }

  @Test
  void aLetterOnAClosedChannelViolatesGenuine() {
    send(1, 1, 1, Care.DEFAULT);
    act(2, RECEIVER, new MailFact.Closed(LETTERS));
    handle(3, 1, 1);
    assertThat(at(3).violations("messages.Genuine")).isEqualTo(1);
  }

  @Test
  void aClockBehindTheLettersViolatesGenuine() {
    send(1, 1, 1, Care.DEFAULT);
    act(2, RECEIVER, new MailFact.Handled(SENDER, LETTERS, 1, 1, 7, 6));
    assertThat(at(3).violations("messages.Genuine")).isEqualTo(1);
  }

  @Test
  void aClockBehindAnAcknowledgementViolatesGenuine() {
    send(1, 1, 1, Care.DEFAULT);
    act(2, RECEIVER, new MailFact.Handled(SENDER, LETTERS, 1, 1, 7, 20));
    act(3, SENDER, new MailFact.Delivered(RECEIVER, 1, 1));
    send(4, 1, 2, Care.DEFAULT);
    act(5, RECEIVER, new MailFact.Handled(SENDER, LETTERS, 1, 2, 20, 20));
    assertThat(at(6).violations("messages.Genuine")).isEqualTo(1);
  }

  @Test
  void aClockThatStandsStillViolatesGenuine() {
    act(1, RECEIVER, new Mailed(Optional.of(SENDER), LETTERS, 1, 1, Care.DEFAULT));
    act(2, SENDER, new MailFact.Handled(RECEIVER, LETTERS, 1, 1, 7, 7));
    send(3, 1, 1, Care.DEFAULT);
    handle(4, 1, 1);
    assertThat(at(5).violations("messages.Genuine")).isEqualTo(1);
  }

  @Test
  void aReliableLetterThatIsHandledTwiceViolatesOnceUnlessTheReceiverRestarts() {
    send(1, 1, 1, Care.DEFAULT);
    handle(2, 1, 1);
    fault(3, RECEIVER, "crash");
    fault(4, RECEIVER, "restart");
    act(4, RECEIVER, new MailFact.Opened(LETTERS));
    handle(5, 1, 1);
    assertThat(at(5).violations("messages.Once")).isZero();
    handle(6, 1, 1);
    assertThat(at(6).violations("messages.Once")).isEqualTo(1);
  }

  @Test
  void aLetterOfAnEarlierStartAfterOneOfALaterStartViolatesFresh() {
    send(1, 1, 1, Care.DEFAULT);
    fault(2, SENDER, "crash");
    fault(2, SENDER, "restart");
    send(3, 2, 1, Care.DEFAULT);
    handle(4, 2, 1);
    handle(5, 1, 1);
    assertThat(at(5).violations("messages.Fresh")).isEqualTo(1);
  }

  @Test
  void aStartWithTheNumberOfAnEarlierOneViolatesFresh() {
    send(1, 1, 1, Care.DEFAULT);
    fault(2, SENDER, "crash");
    fault(2, SENDER, "restart");
    send(3, 1, 1, Care.DEFAULT);
    send(3, 1, 2, Care.DEFAULT);
    assertThat(at(5).violations("messages.Fresh")).isEqualTo(1);
  }

  @Test
  void aFalseReceiptViolatesHandled() {
    send(1, 1, 1, Care.DEFAULT);
    act(2, SENDER, new MailFact.Delivered(RECEIVER, 1, 1));
    assertThat(at(3).violations("messages.Handled")).isEqualTo(1);
  }

  @Test
  void aLetterWithoutAnEndViolatesSettledWhileBothAreUp() {
    send(1, 1, 1, Care.DEFAULT);
    fault(2, RECEIVER, "crash");
    assertThat(at(8).violations("messages.Settled")).isZero();
    fault(9, RECEIVER, "restart");
    assertThat(at(13).violations("messages.Settled")).isZero();
    assertThat(at(15).violations("messages.Settled")).isEqualTo(1);
  }

  @Test
  void aLetterAfterItsDeadlineViolatesSettledEvenIfTheReceiverIsDown() {
    send(1, 1, 1, Care.BRIEF);
    fault(2, RECEIVER, "crash");
    assertThat(at(7).violations("messages.Settled")).isZero();
    assertThat(at(9).violations("messages.Settled")).isEqualTo(1);
  }

  @Test
  void aLetterThatIsPendingWhenItsChannelHasClosedViolatesSettled() {
    send(1, 1, 1, Care.DEFAULT);
    send(1, 1, 2, Care.DEFAULT);
    act(2, SENDER, new MailFact.Closed(LETTERS));
    act(2, SENDER, new MailFact.Failed(RECEIVER, 1, 1));
    assertThat(at(3).violations("messages.Settled")).isEqualTo(1);
  }

  @Test
  void aLetterThatIsGivenUpBeforeItsDeadlineViolatesSettledUnlessAClockIsWrong() {
    send(1, 1, 1, Care.BRIEF);
    act(6, SENDER, new MailFact.Failed(RECEIVER, 1, 1));
    send(11, 1, 2, Care.BRIEF);
    fault(12, SENDER, "begin", "drift");
    act(13, SENDER, new MailFact.Failed(RECEIVER, 1, 2));
    fault(14, SENDER, "end", "drift");
    assertThat(at(14).violations("messages.Settled")).isZero();
    send(15, 1, 3, Care.BRIEF);
    fault(16, RECEIVER, "crash");
    act(19, SENDER, new MailFact.Failed(RECEIVER, 1, 3));
    assertThat(at(20).violations("messages.Settled")).isEqualTo(1);
  }

  @Test
  void aLetterThatIsGivenUpBeforeItsLastRetryViolatesSettled() {
    fault(1, RECEIVER, "crash");
    for (int number = 1; number <= 2; number++) {
      send(10, 1, number, Care.DEFAULT);
      for (int i = number; i <= 1 + Reliability.DEFAULT.maxRetries(); i++) {
        transmit(10 * NS_PER_S + i, number);
      }
    }
    act(34, SENDER, new MailFact.Failed(RECEIVER, 1, 1));
    assertThat(at(34).violations("messages.Settled")).isZero();
    act(34, SENDER, new MailFact.Failed(RECEIVER, 1, 2));
    assertThat(at(35).violations("messages.Settled")).isEqualTo(1);
  }

  @Test
  void aDatagramThatIsSentTwiceAtOnceViolatesPaced() {
    for (long atNs : List.of(1L, 2L, 2L)) {
      transmit(atNs);
    }
    assertThat(at(3).violations("messages.Paced")).isEqualTo(1);
  }

  @Test
  void aLetterThatIsSentAgainBeforeItsWaitViolatesPaced() {
    long firstNs = MessagesClient.BRIEF.firstRetryMs() * NS_PER_S / 1_000;
    for (int early = 0; early <= 1; early++) {
      int number = early + 1;
      send(10, 1, number, Care.BRIEF);
      long atNs = 10 * NS_PER_S;
      transmit(atNs, number);
      transmit(atNs + firstNs, number);
      double secondNs = (1 - early) * MessagesClient.BRIEF.backoff() * firstNs + early * firstNs;
      transmit(atNs + firstNs + (long) secondNs, number);
      assertThat(at(11).violations("messages.Paced")).isEqualTo(early);
    }
  }

  @Test
  void aPlainLetterThatIsLostInACalmWorldViolatesReceived() {
    send(11, 1, 1, Care.NONE);
    assertThat(at(13).violations("messages.Received")).isEqualTo(1);
  }

  @Test
  void aPlainLetterThatArrivesTwiceInACalmWorldViolatesReceived() {
    send(11, 1, 1, Care.NONE);
    handle(11, 1, 1);
    handle(11, 1, 1);
    assertThat(at(13).violations("messages.Received")).isEqualTo(1);
  }
}
