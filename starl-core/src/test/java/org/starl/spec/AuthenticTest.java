package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.comms.Ack;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Sent;

class AuthenticTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");

  private final Monitors monitors = new Monitors(List.of(new Authentic()));

  private void sent(long timeNs, long number, long content) {
    monitors.observe(
        new Sent(timeNs, A, "b", Ack.CHANNEL, number, 40, Ack.SHAPE, new Ack(content)));
  }

  private void delivered(long timeNs, long number, long content) {
    monitors.observe(new Delivered(timeNs, B, A, Ack.CHANNEL, number, Ack.SHAPE, new Ack(content)));
  }

  private long violations() {
    return monitors.report().violations("datagrams.Authentic");
  }

  @Test
  void aRobotWhoseBodyLeftTheFloorGoesOnSendingAndHearing() {
    sent(1, 1, 7);
    sent(2, 2, 8);
    monitors.observe(new Left(3, A));
    monitors.observe(new Left(3, B));
    delivered(4, 1, 7);
    delivered(4, 2, 8);
    sent(5, 3, 9);
    delivered(6, 3, 9);
    assertThat(violations()).isZero();
    delivered(7, 3, 9);
    assertThat(violations()).isEqualTo(1);
  }

  @Test
  void withoutAMessageItDoesNotApplyAndIsNotHeldAsUnchecked() {
    monitors.finish(9);
    assertThat(monitors.report().inapplicable("datagrams.Authentic"))
        .isEqualTo("no robot sends messages");
  }

  @Test
  void whereAMessageIsSentAndNoneHandledItIsUnchecked() {
    sent(1, 1, 7);
    monitors.finish(9);
    assertThat(monitors.report().inapplicable("datagrams.Authentic")).isEmpty();
    assertThat(monitors.report().neverChecked()).containsExactly("datagrams.Authentic");
  }

  @Test
  void aRobotThatJoinsAgainNumbersFromOne() {
    sent(1, 1, 7);
    sent(1, 2, 8);
    delivered(2, 1, 7);
    monitors.observe(new Left(3, A));
    sent(5, 1, 9);
    delivered(6, 1, 9);
    assertThat(violations()).isZero();
    // Of the robot before it left.
    delivered(7, 2, 8);
    assertThat(violations()).isEqualTo(1);
  }
}
