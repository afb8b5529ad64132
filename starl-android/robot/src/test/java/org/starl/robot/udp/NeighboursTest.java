package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_S;

import java.net.InetSocketAddress;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.robot.udp.Neighbours.Verdict;
import org.starl.session.Nonce;
import org.starl.session.Start;

/** Only a beacon with this start's nonce changes anything; an earlier start is refused. */
class NeighboursTest {

  private static final RobotId ME = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");
  private static final Participants BOTH = Participants.of(List.of(ME, OTHER));
  private static final InetSocketAddress THERE = new InetSocketAddress("127.0.0.1", 1);
  private static final long S = NS_PER_S;
  private static final Start MINE = start(9, 1, 100);
  private static final Start FIRST = start(5, 1, 200);

  private final Neighbours neighbours = new Neighbours(ME, MINE, BOTH, 3 * S, 0);

  private static Start start(long epoch, int boot, long nonce) {
    return new Start(epoch, boot, new Nonce(0, nonce));
  }

  private static Beacon beacon(
      RobotId from, Start start, long count, @Nullable RobotId to, Nonce echo, Answer answer) {
    return new Beacon(from, start, count, null, 1, to, echo, answer);
  }

  /** A beacon of the other robot that contains the nonce of this robot's start. */
  private static Beacon fresh(Start start, long count) {
    return beacon(OTHER, start, count, ME, MINE.nonce(), Answer.ACCEPTED);
  }

  private Verdict hear(Beacon beacon, long nowNs) {
    return neighbours.hear(beacon, THERE, nowNs);
  }

  @Test
  void aBeaconWithoutThisStartsNonceProvesNothing() {
    Beacon recorded = beacon(OTHER, FIRST, 7, ME, new Nonce(0, 99), Answer.ACCEPTED);

    assertThat(hear(recorded, S)).isEqualTo(Verdict.UNPROVEN);
    assertThat(hear(beacon(OTHER, FIRST, 8, null, Nonce.NONE, Answer.ACCEPTED), 2 * S))
        .isEqualTo(Verdict.UNPROVEN);
    assertThat(neighbours.lastHeardNs(OTHER)).isNull();
    assertThat(neighbours.echoTo(OTHER)).isEqualTo(FIRST.nonce());
    assertThat(hear(fresh(FIRST, 9), 3 * S)).isEqualTo(Verdict.STARTED);
  }

  @Test
  void answersToUnprovenBeaconsAreFew() {
    Beacon recorded = beacon(OTHER, FIRST, 7, ME, new Nonce(0, 99), Answer.ACCEPTED);
    int answers = 0;
    for (long ms = 0; ms < 1000; ms++) {
      answers += hear(recorded, ms * 1_000_000) == Verdict.UNPROVEN ? 1 : 0;
    }

    assertThat(answers).isEqualTo(10);
  }

  @Test
  void aRecordingDoesNotMoveOrRestartARobotThatWasHeard() {
    hear(fresh(FIRST, 1), S);
    Beacon recorded = beacon(OTHER, start(5, 8, 77), 9, ME, new Nonce(0, 99), Answer.ACCEPTED);
    neighbours.hear(recorded, new InetSocketAddress("127.0.0.1", 666), 2 * S);

    assertThat(neighbours.addressOf(OTHER)).isEqualTo(THERE);
    assertThat(neighbours.echoTo(OTHER)).isEqualTo(FIRST.nonce());
    assertThat(hear(fresh(FIRST, 2), 2 * S)).isEqualTo(Verdict.HEARD);
  }

  @Test
  void anEarlierOrEqualStartIsRefusedAndALaterOneAccepted() {
    Start second = start(5, 2, 201);
    assertThat(hear(fresh(second, 1), S)).isEqualTo(Verdict.STARTED);
    assertThat(hear(fresh(FIRST, 50), 2 * S)).isEqualTo(Verdict.REFUSED);
    assertThat(neighbours.answerTo(OTHER, FIRST)).isEqualTo(Answer.LATER_START);
    Start sameNumber = start(5, 2, 202);
    assertThat(hear(fresh(sameNumber, 50), 3 * S)).isEqualTo(Verdict.REFUSED);
    assertThat(hear(fresh(start(5, 3, 203), 1), 4 * S)).isEqualTo(Verdict.STARTED);
  }

  @Test
  void aRobotWithAnotherStorageIsRefused() {
    Start known = start(5, 7, 299);
    neighbours.remember(OTHER, known);
    Start lost = start(6, 1, 300);

    assertThat(hear(fresh(lost, 1), S)).isEqualTo(Verdict.REFUSED);
    assertThat(neighbours.answerTo(OTHER, lost)).isEqualTo(Answer.OTHER_STORAGE);
    assertThat(hear(fresh(start(5, 6, 301), 1), 2 * S)).isEqualTo(Verdict.REFUSED);
    assertThat(hear(fresh(known, 1), 3 * S)).isEqualTo(Verdict.STARTED);
  }

  /** Copies of one storage on two machines: this robot's own restart does not let the second in. */
  @Test
  void twoStartsOfOneBootNumberAreNotBothAcceptedEvenAfterARestart() {
    neighbours.remember(OTHER, start(5, 7, 299));

    assertThat(hear(fresh(start(5, 7, 302), 1), S)).isEqualTo(Verdict.REFUSED);
    assertThat(hear(fresh(start(5, 8, 303), 1), 2 * S)).isEqualTo(Verdict.STARTED);
  }

  @Test
  void robotsThatRefuseEachOtherBothStop() {
    neighbours.remember(OTHER, start(5, 7, 299));
    Beacon refusing = beacon(OTHER, start(6, 1, 300), 1, ME, MINE.nonce(), Answer.OTHER_STORAGE);

    assertThat(hear(refusing, S)).isEqualTo(Verdict.REFUSES_US);
  }

  @Test
  void aRefusalByARobotThatIsRefusedStopsNoRobotThatAThirdAccepts() {
    RobotId third = new RobotId("bot2");
    Neighbours ofThree =
        new Neighbours(ME, MINE, Participants.of(List.of(ME, OTHER, third)), 3 * S, 0);
    ofThree.remember(OTHER, start(5, 7, 299));
    Beacon accepting = beacon(third, start(7, 1, 500), 1, ME, MINE.nonce(), Answer.ACCEPTED);
    Beacon refusing = beacon(OTHER, start(6, 1, 300), 1, ME, MINE.nonce(), Answer.OTHER_STORAGE);

    assertThat(ofThree.hear(accepting, THERE, S)).isEqualTo(Verdict.STARTED);
    assertThat(ofThree.hear(refusing, THERE, 2 * S)).isEqualTo(Verdict.REFUSED);
    assertThat(ofThree.newlySuspected(5 * S)).contains(third);
    assertThat(ofThree.hear(refusing, THERE, 5 * S)).isEqualTo(Verdict.REFUSES_US);
  }

  @Test
  void refusalsAreFew() {
    neighbours.remember(OTHER, start(5, 7, 299));
    int refusals = 0;
    for (int ms = 0; ms < 1000; ms++) {
      refusals += hear(fresh(start(6, 1, 300), 1), ms * 1_000_000L) == Verdict.REFUSED ? 1 : 0;
    }

    assertThat(refusals).isEqualTo(10);
  }

  @Test
  void aSecondMachineOfThisNameIsKnownByAFreshBeaconOnly() {
    Start twin = start(9, 2, 400);
    Beacon recorded = beacon(ME, twin, 1, ME, new Nonce(0, 99), Answer.ACCEPTED);

    assertThat(hear(beacon(ME, MINE, 1, null, Nonce.NONE, Answer.ACCEPTED), S))
        .isEqualTo(Verdict.OWN);
    assertThat(hear(beacon(ME, MINE, 1, ME, MINE.nonce(), Answer.ACCEPTED), S))
        .as("its own beacon, sent back")
        .isEqualTo(Verdict.OWN);
    assertThat(hear(recorded, S)).isEqualTo(Verdict.UNPROVEN);
    assertThat(hear(beacon(ME, twin, 2, ME, MINE.nonce(), Answer.ACCEPTED), S))
        .isEqualTo(Verdict.TWIN);
  }

  @Test
  void aRefusalCountsOnlyIfItIsOfThisStart() {
    Beacon old = beacon(OTHER, FIRST, 1, ME, new Nonce(0, 99), Answer.LATER_START);
    Beacon now = beacon(OTHER, FIRST, 2, ME, MINE.nonce(), Answer.LATER_START);

    assertThat(hear(old, S)).isEqualTo(Verdict.UNPROVEN);
    assertThat(hear(now, S)).isEqualTo(Verdict.REFUSES_US);
  }

  @Test
  void beaconsOfOthersAndToOthersAreStrange() {
    assertThat(hear(beacon(new RobotId("spy"), FIRST, 1, null, Nonce.NONE, Answer.ACCEPTED), S))
        .isEqualTo(Verdict.STRANGE);
    assertThat(hear(beacon(OTHER, FIRST, 1, OTHER, MINE.nonce(), Answer.ACCEPTED), S))
        .isEqualTo(Verdict.STRANGE);
  }

  @Test
  void aSilentRobotIsSuspectedOnceAndMayReturn() {
    assertThat(neighbours.newlySuspected(3 * S)).isEmpty();
    assertThat(neighbours.newlySuspected(3 * S + 1)).containsExactly(OTHER);
    assertThat(neighbours.newlySuspected(9 * S)).isEmpty();
    assertThat(hear(fresh(FIRST, 1), 9 * S)).isEqualTo(Verdict.STARTED);
    assertThat(neighbours.lastHeardNs(OTHER)).isEqualTo(9 * S);
    assertThat(neighbours.newlySuspected(12 * S)).isEmpty();
    assertThat(neighbours.newlySuspected(12 * S + 1)).containsExactly(OTHER);
    assertThat(hear(fresh(FIRST, 2), 13 * S)).isEqualTo(Verdict.APPEARED);
  }

  @Test
  void aReplayedBeaconDoesNotEndASuspicion() {
    Beacon beacon = fresh(FIRST, 7);
    hear(beacon, S);

    assertThat(hear(beacon, 2 * S)).isEqualTo(Verdict.OLD);
    assertThat(hear(fresh(FIRST, 6), 2 * S)).isEqualTo(Verdict.OLD);
    assertThat(neighbours.lastHeardNs(OTHER)).isEqualTo(S);
  }
}
