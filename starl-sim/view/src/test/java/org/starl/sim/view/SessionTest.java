package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.Failure;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceLoader;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

class SessionTest {

  private static final RobotId BOT = new RobotId("bot0");

  private static Failure failure(Failure.Kind kind, long atS) {
    return new Failure(
        kind, "", "", "headline", atS * Time.NS_PER_S, List.of(), null, List.of(), "", List.of());
  }

  /** The reader of a trace tells at once that its run did not finish; checks tell the rest later. */
  @Test
  void aTraceOpensAtItsViolationAndNotAtItsEnd() {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    new TraceLoader(recording, observers -> {}, List::of, List::of); // nothing is checked yet
    recording.started(new TraceHeader("0", "wander", 7, 8, Map.of(), List.of(BOT)));
    recording.observed(new TraceEvent.Joined(0, BOT, new Pose(0, 0, 0), 150));
    recording.wentWrong(failure(Failure.Kind.UNFINISHED, 60));
    recording.over(60 * Time.NS_PER_S);
    Session session = new Session(recording, null);
    session.playback().play();
    session.tick(0, 0);
    assertThat(session.playback().isPlaying()).isTrue();
    assertThat(session.playback().nowNs()).isZero();
    recording.wentWrong(failure(Failure.Kind.VIOLATED, 33));
    session.tick(0, 0);
    assertThat(session.playback().isPlaying()).isFalse();
    assertThat(session.playback().nowNs()).isEqualTo(33 * Time.NS_PER_S);
  }
}
