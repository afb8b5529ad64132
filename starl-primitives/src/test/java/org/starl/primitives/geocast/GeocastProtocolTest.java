package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.primitives.geocast.GeocastWorld.MS;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

class GeocastProtocolTest {

  private static final RobotId ME = new RobotId("me");
  private static final RobotId ANNA = new RobotId("anna");
  private static final RobotId BERT = new RobotId("bert");
  private static final ProcessId ORIGIN = ProcessId.first(ANNA, 7);
  private static final Region AREA = new Circle(new Point(0, 0), 1_000);

  private final List<String> effects = new ArrayList<>();
  private final List<GeocastMessage.Copy<String>> sent = new ArrayList<>();
  private double insideMm = 1;

  private final class Port implements GeocastPort<String> {
    @Override
    public void broadcast(GeocastMessage.Copy<String> copy) {
      sent.add(copy);
    }

    @Override
    public void acknowledge(RobotId to, GeocastMessage.Ack<String> ack) {
      effects.add("ack " + ack.id().number() + " to " + to);
    }

    @Override
    public double surelyInsideMm(Region area) {
      assertThat(area).isEqualTo(AREA);
      return insideMm;
    }

    @Override
    public void deliver(GeocastId id, String message) {
      effects.add("deliver " + message);
    }

    @Override
    public void dismissed(GeocastId id, Dismissal why) {
      effects.add("dismiss " + why.name());
    }
  }

  private final GeocastProtocol<String> protocol = protocol(0, false);

  private GeocastProtocol<String> protocol(long skewNs, boolean openMembership) {
    return new GeocastProtocol<>(
        ProcessId.first(ME, 1),
        Participants.of(ME, ANNA, BERT),
        new GeocastSettings(100, 1_000, skewNs, openMembership),
        new Port());
  }

  private static GeocastMessage.Copy<String> copy(long number, long startMs, long deadlineMs) {
    GeocastId id = new GeocastId(ORIGIN, number);
    return new GeocastMessage.Copy<>(id, AREA, startMs * MS, deadlineMs * MS, "m" + number);
  }

  @Test
  void aCopyInTheAreaAndInTimeIsDeliveredAndAcknowledged() {
    protocol.received(ANNA, copy(1, 10, 20), 15 * MS);
    assertThat(effects).containsExactly("deliver m1", "ack 1 to anna");
  }

  @Test
  void aSecondCopyIsOnlyAcknowledged() {
    protocol.received(ANNA, copy(1, 10, 20), 15 * MS);
    effects.clear();
    insideMm = 0;
    protocol.received(ANNA, copy(1, 10, 20), 16 * MS);
    assertThat(effects).containsExactly("ack 1 to anna");
  }

  /** The 65th delivery is the first to forget. */
  @Test
  void whatMayStillArriveIsNotForgotten() {
    for (long number = 1; number <= 65; number++) {
      protocol.received(ANNA, copy(number, 10, 20), 20 * MS);
    }
    effects.clear();
    protocol.received(ANNA, copy(1, 10, 20), 20 * MS);
    assertThat(effects).containsExactly("ack 1 to anna");
  }

  @Test
  void aCopyReachesEveryRobotWithinTheLongestWaitAndADelay() {
    assertThat(new GeocastSettings(100, 1_000, 0, false).reachNs(7)).isEqualTo(1_000 * MS + 7);
  }

  @Test
  void aCopyAtTheDeadlineIsInTimeAndALaterOneIsNot() {
    protocol.received(ANNA, copy(1, 10, 20), 20 * MS);
    protocol.received(ANNA, copy(2, 10, 20), 20 * MS + 1);
    assertThat(effects).containsExactly("deliver m1", "ack 1 to anna", "dismiss LATE");
  }

  @Test
  void theSkewOfClocksShortensTheInterval() {
    GeocastProtocol<String> skewed = protocol(3 * MS, false);
    skewed.received(ANNA, copy(1, 10, 20), 17 * MS);
    skewed.received(ANNA, copy(2, 10, 20), 17 * MS + 1);
    skewed.received(ANNA, copy(3, 30, 40), 27 * MS);
    skewed.received(ANNA, copy(4, 30, 40), 27 * MS - 1);
    assertThat(effects)
        .containsExactly(
            "deliver m1",
            "ack 1 to anna",
            "dismiss LATE",
            "deliver m3",
            "ack 3 to anna",
            "dismiss EARLY");
  }

  @Test
  void aRobotThatMayBeOutsideDropsTheCopyAndMayDeliverTheNext() {
    insideMm = 0;
    protocol.received(ANNA, copy(1, 10, 20), 15 * MS);
    insideMm = Double.NaN;
    protocol.received(ANNA, copy(1, 10, 20), 16 * MS);
    insideMm = 0.001;
    protocol.received(ANNA, copy(1, 10, 20), 17 * MS);
    assertThat(effects)
        .containsExactly("dismiss OUTSIDE", "dismiss OUTSIDE", "deliver m1", "ack 1 to anna");
  }

  @Test
  void aCopyFromAnotherSenderIsIgnored() {
    protocol.received(BERT, copy(1, 10, 20), 15 * MS);
    assertThat(effects).isEmpty();
  }

  @Test
  void deliveriesAreForgottenOnlyAfterTheirDeadline() {
    for (int i = 1; i <= 1_000; i++) {
      protocol.received(ANNA, copy(i, i, i + 50), i * MS);
    }
    effects.clear();
    for (int i = 1; i <= 1_000; i++) {
      protocol.received(ANNA, copy(i, i, i + 50), 1_001 * MS);
    }
    assertThat(effects).doesNotContain("deliver m1000").noneMatch(e -> e.startsWith("deliver"));
  }

  @Test
  void copiesAreRepeatedWithGrowingPausesUntilTheDeadline() {
    GeocastReceipt receipt = protocol.do_geocast("m", AREA, 600 * MS, 0);
    List<Long> timesMs = runTimers(protocol);
    assertThat(timesMs).containsExactly(100L, 250L, 475L, 600L);
    assertThat(sent).hasSize(4).containsOnly(sent.get(0));
    assertThat(sent.get(0).deadlineNs()).isEqualTo(600 * MS);
    assertThat(receipt.isComplete()).isTrue();
    assertThat(protocol.isComplete()).isTrue();
  }

  @Test
  void acknowledgementsOfTheWholeDeploymentCompleteAGeocast() {
    assertThat(protocol.isComplete()).as("before the first").isFalse();
    GeocastReceipt receipt = protocol.do_geocast("m", AREA, 600 * MS, 0);
    assertThat(protocol.isComplete()).isFalse();
    protocol.received(ANNA, new GeocastMessage.Ack<>(receipt.id()), 5 * MS);
    protocol.received(ANNA, new GeocastMessage.Ack<>(receipt.id()), 6 * MS);
    assertThat(receipt.isComplete()).isFalse();
    protocol.received(BERT, new GeocastMessage.Ack<>(receipt.id()), 7 * MS);
    assertThat(receipt.acknowledgedBy()).containsExactly(ANNA, BERT);
    assertThat(receipt.isComplete()).isTrue();
    assertThat(protocol.isComplete()).isTrue();
    assertThat(protocol.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void withOpenMembershipNoAcknowledgementCompletesAGeocast() {
    GeocastProtocol<String> open = protocol(0, true);
    GeocastReceipt receipt = open.do_geocast("m", AREA, 600 * MS, 0);
    open.received(ANNA, new GeocastMessage.Ack<>(receipt.id()), 5 * MS);
    open.received(BERT, new GeocastMessage.Ack<>(receipt.id()), 7 * MS);
    assertThat(runTimers(open)).last().isEqualTo(600L);
  }

  @Test
  void anAcknowledgementCountsOnlyForItsGeocast() {
    GeocastReceipt first = protocol.do_geocast("a", AREA, 600 * MS, 0);
    GeocastReceipt second = protocol.do_geocast("b", AREA, 600 * MS, 0);
    protocol.received(BERT, new GeocastMessage.Ack<>(second.id()), 7 * MS);
    assertThat(first.acknowledgedBy()).isEmpty();
    assertThat(second.acknowledgedBy()).containsExactly(BERT);
  }

  @Test
  void anAcknowledgementOfTheNumberOfAnEarlierStartDoesNotCount() {
    GeocastReceipt receipt = protocol.do_geocast("a", AREA, 600 * MS, 0);
    GeocastId earlier = new GeocastId(ProcessId.first(ME, 0), receipt.id().number());
    protocol.received(BERT, new GeocastMessage.Ack<>(earlier), 7 * MS);
    assertThat(receipt.acknowledgedBy()).isEmpty();
  }

  @Test
  void eachGeocastIsRepeatedAtItsOwnTimes() {
    protocol.do_geocast("one", AREA, 10_000 * MS, 0);
    protocol.do_geocast("two", AREA, 10_000 * MS, 60 * MS);
    sent.clear();
    protocol.timer(100 * MS);
    protocol.timer(160 * MS);
    assertThat(sent).extracting(GeocastMessage.Copy::message).containsExactly("one", "two");
  }

  @Test
  void anAcknowledgementFromOutsideTheDeploymentStandsForNoRobotOfIt() {
    GeocastReceipt receipt = protocol.do_geocast("m", AREA, 10_000 * MS, 0);
    GeocastMessage.Ack<String> ack = new GeocastMessage.Ack<>(receipt.id());
    protocol.received(ANNA, ack, 1);
    protocol.received(new RobotId("guest"), ack, 1);
    assertThat(receipt.isComplete()).isFalse();
    protocol.received(BERT, ack, 1);
    assertThat(receipt.isComplete()).isTrue();
  }

  @Test
  void anIntervalThatOverflowsIsRefused() {
    assertThatThrownBy(() -> protocol.do_geocast("m", new Everywhere(), Long.MAX_VALUE, 1))
        .isInstanceOf(ArithmeticException.class);
  }

  private static List<Long> runTimers(GeocastProtocol<String> protocol) {
    List<Long> timesMs = new ArrayList<>();
    while (protocol.wakeAtNs() != Long.MAX_VALUE) {
      long nowNs = protocol.wakeAtNs();
      timesMs.add(nowNs / MS);
      protocol.timer(nowNs);
    }
    return timesMs;
  }
}
