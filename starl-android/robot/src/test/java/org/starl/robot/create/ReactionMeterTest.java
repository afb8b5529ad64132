package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The time from a command to its effect. */
class ReactionMeterTest {

  private static final long MS = 1_000_000;

  private final ReactionMeter meter = new ReactionMeter(200);

  @Test
  void isFromTheChangeToHalfOfIt() {
    meter.sent(200, 10 * MS);
    meter.sent(210, 20 * MS);
    assertThat(meter.odometry(90, 40 * MS)).isNull();
    assertThat(meter.odometry(110, 60 * MS)).isNull();
    meter.sent(0, 100 * MS);
    assertThat(meter.odometry(100, 170 * MS)).isNull();
    assertThat(meter.summary())
        .startsWith("2 commands were followed by odometry after 50 ms at the median, ")
        .contains(" 70 ms at most; limits.reactionMs is 200");
  }

  @Test
  void tooLongIsToldOnce() {
    meter.sent(200, 0);
    assertThat(meter.odometry(0, 200 * MS)).isNull();
    assertThat(meter.odometry(0, 201 * MS)).contains("within 200 ms");
    assertThat(meter.odometry(0, 300 * MS)).isNull();
    assertThat(new ReactionMeter(200).summary()).isEqualTo("no command was followed by odometry");
  }
}
