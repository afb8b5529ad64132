package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.starl.sim.view.Runs.A;
import static org.starl.sim.view.Runs.B;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.platform.LogSink.Level;
import org.starl.sim.replay.Recording;
import org.starl.trace.TraceEvent;

class InspectionTest {

  private static Recording recording() {
    Runs runs =
        Runs.plain()
            .says(1, A, "WAIT")
            .happens(new TraceEvent.Variable(2, A, "mutex/m", "crit", "true"))
            .happens(new TraceEvent.Sent(3, A, "*", "geocast/g", 1, 9, "Copy[x=1]"))
            .happens(new TraceEvent.Delivered(4, B, A, "geocast/g", 1, "Copy[x=1]"))
            .happens(new TraceEvent.Dropped(5, A, "bot1", "loss"))
            .happens(new TraceEvent.Action(6, A, "mutex/m", "release", List.of("C")))
            .happens(new TraceEvent.Fault(7, A, TraceEvent.Fault.CRASH, ""));
    runs.recording().logged(6, A, Level.INFO, "app", "written");
    return runs.over(10);
  }

  @Test
  void theStateOfARobotIsItsBodyAndItsVariablesByPrimitive() {
    Session session = new Session(recording(), null);
    session.playback().seek(5);
    assertThat(Inspection.state(session.scene(), A))
        .extracting(Inspection.Row::name, Inspection.Row::value)
        .contains(
            tuple("position", "0 mm, 0 mm"),
            tuple("program", "runs"),
            tuple("mutex/m", ""),
            tuple("crit", "true"));
    session.playback().seek(10);
    assertThat(Inspection.state(session.scene(), A))
        .extracting(Inspection.Row::value)
        .contains("crashed");
  }

  @Test
  void messagesUpToTheCurrentTimeAreListedLatestFirst() {
    Recording recording = recording();
    assertThat(Inspection.messages(recording, recording.size(), A))
        .extracting(Inspection.Line::what)
        .containsExactly("\u2715 bot1", "\u2192 all");
    assertThat(Inspection.messages(recording, recording.firstAfter(3), A)).hasSize(1);
    assertThat(Inspection.messages(recording, recording.size(), B))
        .extracting(Inspection.Line::text)
        .containsExactly("Copy  geocast/g  [x=1]");
  }

  @Test
  void theLogListsActionsAndLogMessages() {
    Recording recording = recording();
    assertThat(Inspection.log(recording, recording.size(), A))
        .extracting(Inspection.Line::text)
        .containsExactlyInAnyOrder("crash ", "release(C)", "written");
    assertThat(Inspection.log(recording, recording.firstAfter(3), A)).isEmpty();
  }
}
