package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The time of a simulated body in real time, and its wheels' watchdog. */
class BodyClockTest {

  private static final long MS = 1_000_000;

  private final List<String> held = new ArrayList<>();
  private long pieceNs = 1_000 * MS;
  private final BodyClock clock = new BodyClock(() -> pieceNs, this::scaleWheels);

  private void scaleWheels(double factor) {
    held.add((factor == 0 ? "held at " : "let go at ") + clock.shownNs() / MS);
  }

  @Test
  void theBodyMovesOnlyWhenTheProgramReadsTheClock() {
    pieceNs += 50 * MS;
    assertThat(clock.shownNs()).isEqualTo(1_000 * MS);
    assertThat(clock.nowNs()).isEqualTo(1_050 * MS).isEqualTo(clock.shownNs());
    assertThat(held).isEmpty();
  }

  @Test
  void theWatchdogStopsTheWheelsOfASilentProgram() {
    pieceNs += BodyClock.WATCHDOG_NS;
    clock.nowNs();
    assertThat(held).isEmpty();
    pieceNs += 1_000 * MS;
    clock.nowNs();
    assertThat(held).containsExactly("held at 1400", "let go at 2200");
    assertThat(clock.longestPauseNs()).isEqualTo(1_000 * MS);
  }
}
