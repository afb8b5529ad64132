package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.sim.view.Runs.SECOND_NS;

import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

class PlaybackTest {

  private static final long TICK_NS = 100_000_000;

  private static String location(Playback playback) {
    return playback.scene().text(Runs.A, Instance.APP, "location");
  }

  @Test
  void speedIsSimulatedSecondsPerRealSecond() {
    Playback playback = new Playback(Runs.seconds(100), 5);
    playback.play();
    for (int i = 0; i < 10; i++) {
      playback.tick(TICK_NS);
    }
    assertThat(playback.nowNs()).isEqualTo(5 * SECOND_NS);
    assertThat(location(playback)).isEqualTo("5");
  }

  @Test
  void timeStandsStillWhilePaused() {
    Playback playback = new Playback(Runs.seconds(10), 1);
    playback.tick(TICK_NS);
    assertThat(playback.nowNs()).isZero();
  }

  @Test
  void playingAtTheEndStartsAgain() {
    Playback playback = new Playback(Runs.seconds(3), Playback.NO_LIMIT);
    playback.play();
    playback.tick(TICK_NS);
    assertThat(playback.isAtEnd()).isTrue();
    assertThat(playback.isPlaying()).isFalse();
    playback.play();
    assertThat(playback.nowNs()).isZero();
    assertThat(playback.isPlaying()).isTrue();
  }

  @Test
  void stepsGoBackAndForth() {
    Playback playback = new Playback(Runs.seconds(10), 1);
    playback.seek(7 * SECOND_NS);
    playback.stepTime(-3 * SECOND_NS);
    assertThat(location(playback)).isEqualTo("4");
    playback.stepEvents(-1);
    assertThat(location(playback)).isEqualTo("3");
    playback.stepEvents(2);
    assertThat(location(playback)).isEqualTo("5");
  }

  @Test
  void stepsStopAtTheStartAndAtTheEnd() {
    Playback playback = new Playback(Runs.seconds(3), 1);
    for (int i = 0; i < 5; i++) {
      playback.stepEvents(-1);
    }
    assertThat(playback.index()).isLessThanOrEqualTo(2);
    playback.stepTime(-SECOND_NS);
    assertThat(playback.nowNs()).isZero();
    for (int i = 0; i < 9; i++) {
      playback.stepEvents(1);
    }
    assertThat(location(playback)).isEqualTo("3");
    assertThat(playback.isAtEnd()).isTrue();
  }

  @Test
  void neighboursAreTheNextAndPreviousMarks() {
    Recording recording =
        Runs.plain()
            .violates(2 * SECOND_NS, "one")
            .happens(new TraceEvent.Fault(3 * SECOND_NS, Runs.A, TraceEvent.Fault.CRASH, ""))
            .violates(5 * SECOND_NS, "two")
            .over(9 * SECOND_NS);
    Playback playback = new Playback(recording, 1);
    Mark first = Objects.requireNonNull(playback.neighbour(true, Mark.Kind.VIOLATION));
    playback.toMark(first);
    assertThat(playback.nowNs()).isEqualTo(2 * SECOND_NS);
    assertThat(Objects.requireNonNull(playback.violation()).text()).contains("one");
    Mark crash = Objects.requireNonNull(playback.neighbour(true, null));
    assertThat(crash.kind()).isEqualTo(Mark.Kind.CRASH);
    playback.toMark(Objects.requireNonNull(playback.neighbour(true, Mark.Kind.VIOLATION)));
    assertThat(playback.nowNs()).isEqualTo(5 * SECOND_NS);
    assertThat(playback.neighbour(true, null)).isNull();
    playback.toMark(Objects.requireNonNull(playback.neighbour(false, Mark.Kind.VIOLATION)));
    assertThat(playback.nowNs()).isEqualTo(2 * SECOND_NS);
    assertThat(playback.neighbour(false, null)).isNull();
  }

  @Test
  void aStepBeyondALiveRunWaitsForIt() {
    Runs run = Runs.plain();
    Playback playback = new Playback(run.recording(), 1);
    playback.stepTime(2 * SECOND_NS);
    assertThat(playback.nowNs()).isZero();
    assertThat(playback.wantedNs(1)).isGreaterThan(2 * SECOND_NS);
    run.says(3 * SECOND_NS, Runs.A, "there");
    playback.tick(TICK_NS);
    assertThat(playback.nowNs()).isEqualTo(2 * SECOND_NS);
    assertThat(location(playback)).isEmpty();
    playback.stepEvents(1);
    assertThat(location(playback)).isEqualTo("there");
    playback.stepEvents(1);
    run.says(4 * SECOND_NS, Runs.A, "farther");
    playback.tick(TICK_NS);
    assertThat(location(playback)).isEqualTo("farther");
  }

  @Test
  void fasterAndSlowerStayWithinTheSpeeds() {
    Playback playback = new Playback(Runs.seconds(1), 3);
    playback.faster();
    assertThat(playback.speed()).isEqualTo(5);
    playback.slower();
    assertThat(playback.speed()).isEqualTo(2);
    for (int i = 0; i < 20; i++) {
      playback.slower();
    }
    assertThat(playback.speed()).isEqualTo(0.1);
    for (int i = 0; i < 20; i++) {
      playback.faster();
    }
    assertThat(playback.speed()).isEqualTo(Playback.NO_LIMIT);
  }

  @Test
  void aTickIsLimitedInEvents() {
    Runs run = Runs.plain();
    for (int i = 0; i < 100_000; i++) {
      run.says(1 + i, Runs.A, "x");
    }
    Playback playback = new Playback(run.over(SECOND_NS), Playback.NO_LIMIT);
    playback.play();
    playback.tick(TICK_NS);
    assertThat(playback.index()).isBetween(10_000, 30_000);
  }
}
