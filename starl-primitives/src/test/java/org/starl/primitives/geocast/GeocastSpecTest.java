package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Sent;

/** The specification on handwritten traces. */
class GeocastSpecTest {

  private static final String SOURCE = "broadcast/news";
  private static final RobotId ORIGIN = new RobotId("bot0");
  private static final long MS = Time.NS_PER_MS;
  private static final RobotId OTHER = new RobotId("bot1");

  private Monitors monitors = new Monitors(List.of(new GeocastSpec()));

  private void see(TraceEvent... events) {
    List.of(events).forEach(monitors::observe);
  }

  private static Action act(long timeNs, RobotId robot, String name, String... args) {
    return new Action(timeNs, robot, SOURCE, name, List.of(args));
  }

  private void castWithoutReceiversAfterTheFirstDatagram() {
    castWithoutReceivers(1000);
  }

  private void castWithoutReceivers(long intervalNs) {
    for (RobotId robot : List.of(ORIGIN, OTHER)) {
      see(new Joined(0, robot, new Pose(0, 0, 0), 100), act(0, robot, "open", robot + "#1"));
    }
    see(
        act(1, ORIGIN, "BCast", "bot0#1/1", "everywhere", "" + intervalNs),
        act(1, ORIGIN, "copy", "bot0#1/1"),
        new Sent(1, ORIGIN, "*", SOURCE, 1, 10, "copy"));
  }

  @Test
  void aRobotThatACopyReachesMustDeliver() {
    castWithoutReceiversAfterTheFirstDatagram();
    see(new Delivered(20, OTHER, ORIGIN, SOURCE, 1, "copy"));
    monitors.finish(2000);
    assertThat(monitors.report().violations("inclusion")).isEqualTo(1);
  }

  @Test
  void onlyAnUncertainPositionExcusesARobotThatDismissesACopy() {
    for (String why : List.of("early", "late", "outside")) {
      assertThat(violationsAfterDismissal(why, "49")).as(why).isEqualTo(1);
      assertThat(violationsAfterDismissal(why, "51")).as(why).isZero();
    }
  }

  private long violationsAfterDismissal(String why, String errorMm) {
    monitors = new Monitors(List.of(new GeocastSpec()));
    castWithoutReceiversAfterTheFirstDatagram();
    see(
        new Delivered(20, OTHER, ORIGIN, SOURCE, 1, "copy"),
        act(20, OTHER, "dismiss", "bot0#1/1", why, errorMm));
    monitors.finish(2000);
    return monitors.report().violations("inclusion");
  }

  @Test
  void anAcknowledgementBeforeTheDeliveryViolatesAcknowledged() {
    castWithoutReceiversAfterTheFirstDatagram();
    Sent ack = new Sent(20, OTHER, "bot0", SOURCE, 1, 10, "Ack[id=bot0#1/1]");
    see(act(20, OTHER, "deliver", "bot0#1/1"), ack);
    assertThat(monitors.report().violations("acknowledged")).isZero();
    see(new Sent(20, ORIGIN, "bot0", SOURCE, 2, 10, "Ack[id=bot0#1/1]"));
    assertThat(monitors.report().violations("acknowledged")).isEqualTo(1);
    assertThat(monitors.report().checks("acknowledged")).isEqualTo(2);
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
    assertThat(monitors.report().violations("inclusion")).isEqualTo(1);
    monitors = strict(2 * MS + 1);
    castWithoutReceivers(2 * MS);
    monitors.finish(3 * MS);
    assertThat(monitors.report().checks("inclusion")).isZero();
  }

  /** The violations of inclusion if no copy arrives in 3 ms, and a fault ends at {@code endNs}. */
  private long violationsAfterAFault(long endNs) {
    monitors = strict(MS);
    see(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    castWithoutReceivers(3 * MS);
    see(new TraceEvent.Fault(endNs, TraceEvent.Fault.WORLD, "end", "loss(1)"));
    monitors.finish(4 * MS);
    return monitors.report().violations("inclusion");
  }

  /** Copies take {@code delayNs}, and are repeated each ms. */
  private static Monitors strict(long delayNs) {
    GeocastSettings settings = new GeocastSettings(1, 1, 0, false);
    return new Monitors(List.of(new GeocastSpec(50, settings, delayNs)));
  }

  @Test
  void aDatagramOfTheOriginsNextStartIsNoCopy() {
    castWithoutReceiversAfterTheFirstDatagram();
    see(
        act(10, ORIGIN, "open", "bot0#2"),
        new Sent(11, ORIGIN, "bot1", SOURCE, 1, 10, "another"),
        new Delivered(20, OTHER, ORIGIN, SOURCE, 1, "another"));
    monitors.finish(2000);
    assertThat(monitors.report().violations()).isEmpty();
  }
}
