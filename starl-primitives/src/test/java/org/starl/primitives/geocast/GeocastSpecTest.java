package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** The specification on handwritten traces. */
class GeocastSpecTest {

  private static final Instance SOURCE = Instance.of(GeocastFact.BROADCAST, "news");
  private static final Shape<GeocastMessage<String>> MESSAGE = GeocastMessage.shape(Shapes.TEXT);
  private static final RobotId ORIGIN = new RobotId("bot0");
  private static final GeocastId FIRST = new GeocastId(ProcessId.first(ORIGIN, 1), 1);
  private static final long MS = Time.NS_PER_MS;
  private static final RobotId OTHER = new RobotId("bot1");

  private Monitors monitors = new Monitors(List.of(new GeocastSpec()));

  private void see(TraceEvent... events) {
    List.of(events).forEach(monitors::observe);
  }

  private static Action act(long timeNs, RobotId robot, GeocastFact fact) {
    return Action.of(timeNs, robot, SOURCE, GeocastFact.SHAPE, fact);
  }

  private static Action opens(long timeNs, RobotId robot, long incarnation) {
    return act(timeNs, robot, new GeocastFact.Opened(new ProcessId(robot, incarnation)));
  }

  private static GeocastMessage<String> copyOf(GeocastId id) {
    return new GeocastMessage.Copy<>(id, new Everywhere(), 1, 2, "news");
  }

  private static Sent sends(
      long timeNs, RobotId robot, String to, long seq, GeocastMessage<String> message) {
    return new Sent(timeNs, robot, to, SOURCE, seq, 10, MESSAGE, message);
  }

  /** The other robot gets a message of the origin. */
  private static Delivered hears(long timeNs, GeocastMessage<String> message) {
    return new Delivered(timeNs, OTHER, ORIGIN, SOURCE, 1, MESSAGE, message);
  }

  private void castWithoutReceiversAfterTheFirstDatagram() {
    castWithoutReceivers(1000);
  }

  private void castWithoutReceivers(long intervalNs) {
    for (RobotId robot : List.of(ORIGIN, OTHER)) {
      see(new Joined(0, robot, new Pose(0, 0, 0), 100), opens(0, robot, 1));
    }
    see(
        act(1, ORIGIN, new GeocastFact.BCast(FIRST, new Everywhere(), intervalNs)),
        act(1, ORIGIN, new GeocastFact.copy(FIRST)),
        sends(1, ORIGIN, Sent.ALL, 1, copyOf(FIRST)));
  }

  @Test
  void aRobotThatACopyReachesMustDeliver() {
    castWithoutReceiversAfterTheFirstDatagram();
    see(hears(20, copyOf(FIRST)));
    monitors.finish(2000);
    assertThat(monitors.report().violations("geocast.inclusion")).isEqualTo(1);
  }

  @Test
  void onlyAnUncertainPositionExcusesARobotThatDismissesACopy() {
    for (Dismissal why : Dismissal.values()) {
      assertThat(violationsAfterDismissal(why, 49)).as("%s", why).isEqualTo(1);
      assertThat(violationsAfterDismissal(why, 51)).as("%s", why).isZero();
    }
  }

  private long violationsAfterDismissal(Dismissal why, double errorMm) {
    monitors = new Monitors(List.of(new GeocastSpec()));
    castWithoutReceiversAfterTheFirstDatagram();
    see(hears(20, copyOf(FIRST)), act(20, OTHER, new GeocastFact.dismiss(FIRST, why, errorMm)));
    monitors.finish(2000);
    return monitors.report().violations("geocast.inclusion");
  }

  @Test
  void aDismissalForAFalseReasonViolatesDismissed() {
    assertThat(falseReasons(Dismissal.LATE, 20, 5)).isEqualTo(1);
    assertThat(falseReasons(Dismissal.LATE, 1001, 5)).isEqualTo(1);
    assertThat(falseReasons(Dismissal.LATE, 1002, 5)).isZero();
    assertThat(falseReasons(Dismissal.OUTSIDE, 20, 5)).isEqualTo(1);
    assertThat(falseReasons(Dismissal.OUTSIDE, 20, Double.POSITIVE_INFINITY)).isZero();
  }

  private long falseReasons(Dismissal why, long atNs, double errorMm) {
    monitors = strict(MS);
    castWithoutReceiversAfterTheFirstDatagram();
    see(act(atNs, OTHER, new GeocastFact.dismiss(FIRST, why, errorMm)));
    return monitors.report().violations("geocast.Dismissed");
  }

  @Test
  void anAcknowledgementBeforeTheDeliveryViolatesAcknowledged() {
    castWithoutReceiversAfterTheFirstDatagram();
    GeocastMessage<String> ack = new GeocastMessage.Ack<>(FIRST);
    see(act(20, OTHER, new GeocastFact.deliver(FIRST)), sends(20, OTHER, "bot0", 1, ack));
    assertThat(monitors.report().violations("geocast.acknowledged")).isZero();
    see(sends(20, ORIGIN, "bot0", 2, ack));
    assertThat(monitors.report().violations("geocast.acknowledged")).isEqualTo(1);
    assertThat(monitors.report().checks("geocast.acknowledged")).isEqualTo(2);
  }

  @Test
  void aCopyThatIsNotAcknowledgedAtOnceViolatesAnswered() {
    GeocastMessage<String> ack = new GeocastMessage.Ack<>(FIRST);
    for (boolean isRepeated : List.of(false, true)) {
      for (long lateNs : List.of(0, 1)) {
        monitors = new Monitors(List.of(new GeocastSpec().answering()));
        castWithoutReceiversAfterTheFirstDatagram();
        see(hears(20, copyOf(FIRST)), act(20, OTHER, new GeocastFact.deliver(FIRST)));
        if (isRepeated) {
          see(sends(20, OTHER, "bot0", 1, ack), hears(30, copyOf(FIRST)));
        }
        see(sends((isRepeated ? 30 : 20) + lateNs, OTHER, "bot0", 2, ack));
        monitors.finish(2000);
        assertThat(monitors.report().violations("geocast.answered")).isEqualTo(lateNs);
      }
    }
  }

  @Test
  void aMessageThatIsNotRepeatedInTimeViolatesRepeated() {
    for (boolean isAcknowledged : List.of(false, true)) {
      monitors = new Monitors(List.of(new GeocastSpec().answering()));
      see(opens(0, ORIGIN, 1), opens(0, OTHER, 1), casts(), copies(0), copies(149 * MS));
      assertThat(monitors.report().violations("geocast.Repeated")).isZero();
      if (isAcknowledged) {
        GeocastMessage<String> ack = new GeocastMessage.Ack<>(FIRST);
        see(new Delivered(160 * MS, ORIGIN, OTHER, SOURCE, 1, MESSAGE, ack));
      }
      see(copies(350 * MS + 1));
      long expected = isAcknowledged ? 0 : 1;
      assertThat(monitors.report().violations("geocast.Repeated")).isEqualTo(expected);
    }
  }

  @Test
  void aMessageThatIsRepeatedTooSoonViolatesRepeated() {
    for (long early : List.of(0L, 1L)) {
      monitors = new Monitors(List.of(new GeocastSpec().answering()));
      see(opens(0, ORIGIN, 1), opens(0, OTHER, 1), casts(), copies(0), copies(100 * MS));
      see(copies((250 - early) * MS));
      assertThat(monitors.report().violations("geocast.Repeated")).isEqualTo(early);
    }
  }

  private static Action casts() {
    return act(0, ORIGIN, new GeocastFact.BCast(FIRST, new Everywhere(), 2_000 * MS));
  }

  private static Action copies(long timeNs) {
    return act(timeNs, ORIGIN, new GeocastFact.copy(FIRST));
  }

  @Test
  void gcastflagFollowsTheAcknowledgmentsOfAll() {
    assertThat(flagged(false, false, 30)).as("nobody has acknowledged").isZero();
    assertThat(flagged(false, true, 30)).as("complete too early").isEqualTo(1);
    assertThat(flagged(false, true, 1001)).as("the interval is over").isZero();
    assertThat(flagged(true, true, 30)).as("all have acknowledged").isZero();
    assertThat(flagged(true, false, 30)).as("not told").isEqualTo(1);
  }

  /** The other robot acknowledges at 30 ns, or does not; then the flag is this. */
  private long flagged(boolean isAcknowledged, boolean isComplete, long atNs) {
    monitors = new Monitors(List.of(new GeocastSpec().answering()));
    see(flag(0, false));
    castWithoutReceiversAfterTheFirstDatagram();
    if (isAcknowledged) {
      GeocastMessage<String> ack = new GeocastMessage.Ack<>(FIRST);
      see(new Delivered(30, ORIGIN, OTHER, SOURCE, 1, MESSAGE, ack));
    }
    if (isComplete) {
      see(flag(atNs, true));
    }
    see(sends(1500, ORIGIN, Sent.ALL, 2, copyOf(FIRST)));
    return monitors.report().violations("geocast.Gcastflag");
  }

  private static Variable flag(long timeNs, boolean isComplete) {
    return new Variable(timeNs, ORIGIN, SOURCE, GeocastFact.GCASTFLAG, isComplete);
  }

  @Test
  void inAWorldWithoutFaultsARepeatedCopyReachesEveryRobot() {
    assertThat(violationsAfterAFault(MS)).isEqualTo(1);
  }

  @Test
  void whileAFaultIsActiveACopyMayReachNoRobot() {
    assertThat(violationsAfterAFault(2 * MS)).isZero();
  }

  @Test
  void noCopyArrivesInAnIntervalThatIsShorterThanItsDelay() {
    monitors = strict(2 * MS);
    castWithoutReceivers(2 * MS);
    monitors.finish(3 * MS);
    assertThat(monitors.report().violations("geocast.inclusion")).isEqualTo(1);
    monitors = strict(2 * MS + 1);
    castWithoutReceivers(2 * MS);
    monitors.finish(3 * MS);
    assertThat(monitors.report().checks("geocast.inclusion")).isZero();
  }

  /** The violations of inclusion if no copy arrives in 3 ms, and a fault ends at {@code endNs}. */
  private long violationsAfterAFault(long endNs) {
    monitors = strict(MS);
    see(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    castWithoutReceivers(3 * MS);
    see(new TraceEvent.Fault(endNs, TraceEvent.Fault.WORLD, "end", "loss(1)"));
    monitors.finish(4 * MS);
    return monitors.report().violations("geocast.inclusion");
  }

  /** Copies take {@code delayNs}, and are repeated each ms. */
  private static Monitors strict(long delayNs) {
    GeocastSettings settings = new GeocastSettings(1, 1, 0, false);
    return new Monitors(List.of(new GeocastSpec(50, settings, delayNs)));
  }

  @Test
  void aMessageOfTheOriginsNextStartIsNoCopy() {
    castWithoutReceiversAfterTheFirstDatagram();
    GeocastId next = new GeocastId(ProcessId.first(ORIGIN, 2), 1);
    see(
        opens(10, ORIGIN, 2),
        sends(11, ORIGIN, Sent.ALL, 1, copyOf(next)),
        hears(20, copyOf(next)));
    monitors.finish(2000);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void aCopyFromAnotherRobotIsNoCopy() {
    castWithoutReceiversAfterTheFirstDatagram();
    see(new Delivered(20, OTHER, OTHER, SOURCE, 1, MESSAGE, copyOf(FIRST)));
    monitors.finish(2000);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void anAcknowledgementIsNoCopy() {
    castWithoutReceiversAfterTheFirstDatagram();
    see(hears(20, new GeocastMessage.Ack<>(FIRST)));
    monitors.finish(2000);
    assertThat(monitors.report().violations()).isEmpty();
  }
}
