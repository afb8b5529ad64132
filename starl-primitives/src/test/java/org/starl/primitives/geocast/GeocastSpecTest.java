package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Sent;

/** The specification on handwritten traces. */
class GeocastSpecTest {

  private static final String SOURCE = "broadcast/news";
  private static final RobotId ORIGIN = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");

  private Monitors monitors = new Monitors(List.of(new GeocastSpec(50, 0)));

  private void see(TraceEvent... events) {
    List.of(events).forEach(monitors::observe);
  }

  private static Action act(long timeNs, RobotId robot, String name, String... args) {
    return new Action(timeNs, robot, SOURCE, name, List.of(args));
  }

  private void castWithoutReceiversAfterTheFirstDatagram() {
    for (RobotId robot : List.of(ORIGIN, OTHER)) {
      see(new Joined(0, robot, new Pose(0, 0, 0), 100), act(0, robot, "open", robot + "#1"));
    }
    see(
        act(1, ORIGIN, "BCast", "bot0#1/1", "everywhere", "1000"),
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
    monitors = new Monitors(List.of(new GeocastSpec(50, 0)));
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
    Monitors strict = new Monitors(List.of(new GeocastSpec(50, 0, 500)));
    assertThat(withoutFaultsSince(strict, 400)).isEqualTo(1);
  }

  @Test
  void whileAFaultIsActiveACopyMayReachNoRobot() {
    Monitors strict = new Monitors(List.of(new GeocastSpec(50, 0, 500)));
    assertThat(withoutFaultsSince(strict, 600)).isZero();
  }

  /** The violations of inclusion if no copy arrives, and a fault ends at {@code endNs} of 1001. */
  private long withoutFaultsSince(Monitors strict, long endNs) {
    monitors = strict;
    see(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    castWithoutReceiversAfterTheFirstDatagram();
    see(new TraceEvent.Fault(endNs, TraceEvent.Fault.WORLD, "end", "loss(1)"));
    monitors.finish(2000);
    return monitors.report().violations("inclusion");
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
