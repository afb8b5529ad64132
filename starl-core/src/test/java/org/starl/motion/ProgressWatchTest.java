package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.MotionParameters;
import org.starl.geometry.Pose;

class ProgressWatchTest {

  private static final long MS = 1_000_000;
  private static final Pose HERE = new Pose(0, 0, 0);

  private final ProgressWatch watch =
      new ProgressWatch(MotionParameters.builder().stuckAfterMs(5_000).build());

  @Test
  void aBodyThatStandsIsStuckAfterSomeTime() {
    assertThat(isStuckAt(0)).isFalse();
    assertThat(isStuckAt(4_999)).isFalse();
    assertThat(isStuckAt(5_000)).isTrue();
  }

  @Test
  void timeInWhichItWasStoppedOnPurposeDoesNotCount() {
    assertThat(isStuckAt(0)).isFalse();
    watch.excuse(3_000 * MS);
    assertThat(isStuckAt(7_999)).isFalse();
    assertThat(isStuckAt(8_000)).isTrue();
  }

  private boolean isStuckAt(long ms) {
    return watch.update(new Location.Known(HERE, 10, 0.1, ms * MS, 0), 1_000, 0);
  }
}
