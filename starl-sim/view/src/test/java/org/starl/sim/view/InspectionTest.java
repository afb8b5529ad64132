package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.starl.sim.view.Runs.A;
import static org.starl.sim.view.Runs.B;

import org.junit.jupiter.api.Test;
import org.starl.platform.LogSink.Level;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.sim.replay.Recording;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class InspectionTest {

  private static final Instance MUTEX = Instance.of("mutex", "m");
  private static final Instance GEOCAST = Instance.of("geocast", "g");
  private static final Var<Boolean> CRIT = Var.of("crit", Shapes.BOOL);

  /** A message, or a fact. */
  record Copy(int x) {
    static final RecordShape<Copy> SHAPE =
        Shapes.of(Copy.class, Shapes.part("x", Shapes.INT, Copy::x), Copy::new);
  }

  private static final RecordShape<Copy> RELEASE = Copy.SHAPE.named("release");

  private static Recording recording() {
    Runs runs =
        Runs.plain()
            .says(1, A, "WAIT")
            .happens(new TraceEvent.Variable(2, A, MUTEX, CRIT, true))
            .happens(new TraceEvent.Sent(3, A, "*", GEOCAST, 1, 9, Copy.SHAPE, new Copy(1)))
            .happens(new TraceEvent.Delivered(4, B, A, GEOCAST, 1, Copy.SHAPE, new Copy(1)))
            .happens(new TraceEvent.Dropped(5, A, "bot1", "loss"))
            .happens(TraceEvent.Action.of(6, A, MUTEX, RELEASE, new Copy(7)))
            .happens(new TraceEvent.Fault(7, A, TraceEvent.Fault.CRASH, ""));
    runs.recording().logged(6, A, Level.INFO, "app", "written");
    return runs.over(10);
  }

  @Test
  void theStateHasTheBodyAndTheVariablesByPrimitive() {
    Session session = new Session(recording(), null);
    session.playback().seek(5);
    assertThat(Inspection.state(session.scene(), A))
        .extracting(Inspection.Row::name, Inspection.Row::value)
        .contains(
            tuple("position", "0 mm, 0 mm"),
            tuple("program", "running"),
            tuple("mutex/m", ""),
            tuple("crit", "true"));
    session.playback().seek(10);
    assertThat(Inspection.state(session.scene(), A))
        .extracting(Inspection.Row::value)
        .contains("crashed");
  }

  @Test
  void messagesUpToNowAreListedLatestFirst() {
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
  void theLogHasActionsFaultsAndLogLines() {
    Recording recording = recording();
    assertThat(Inspection.log(recording, recording.size(), A))
        .extracting(Inspection.Line::text)
        .containsExactlyInAnyOrder("crash ", "release(7)", "written");
    assertThat(Inspection.log(recording, recording.firstAfter(3), A)).isEmpty();
  }
}
