package org.starl.robot.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;

/** A parent reads the facts that its child writes. */
class ProcessFactTest {

  private static final RobotId BOT0 = new RobotId("bot0");

  private static List<TraceEvent> again(List<ProcessFact> facts) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TraceHeader header = new TraceHeader("0", "a", 7, 8, Map.of(), List.of(BOT0));
    ProcessTrace trace = new ProcessTrace(BOT0, header, out);
    facts.forEach(fact -> trace.report(() -> 5, fact));
    trace.end(6);
    List<TraceEvent> read = new ArrayList<>();
    try (TraceReader reader =
        new TraceReader(
            "trace", new ByteArrayInputStream(out.toByteArray()), ProcessFact.VOCABULARY)) {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        read.add(event);
      }
    }
    return read;
  }

  @Test
  void allFactsAreReadAsWritten() throws IOException {
    Wait wait = new Wait(Instance.of("mutex", "m"), "requests [A]", List.of(BOT0));
    List<ProcessFact> facts =
        List.of(
            new ProcessFact.Hello(1L << 40),
            new ProcessFact.Port(65_535),
            new ProcessFact.WantsPlace(),
            new ProcessFact.Alive(3, 2, 1),
            new ProcessFact.Finished(List.of("a, b", "")),
            new ProcessFact.Waits("a fix", List.of(wait, new Wait(wait.source(), "x", List.of()))),
            new ProcessFact.Log(Level.WARN, "tag", "a\n\"line\""),
            new ProcessFact.Failed("at\n\tline"),
            new ProcessFact.Clock("?", -1, Long.MAX_VALUE));
    assertThat(facts).hasSize(ProcessFact.SHAPE.records().size());

    List<TraceEvent> read = again(facts);
    assertThat(read).allMatch(ProcessFact::isProcessEvent);
    assertThat(read).map(event -> ((Action) event).fact()).isEqualTo(facts);
  }

  @Test
  void anActionOfTheAppIsNotOfTheProcess() {
    Note note = new Note("hello", List.of());
    assertThat(ProcessFact.isProcessEvent(Action.of(0, BOT0, Instance.APP, Note.SHAPE, note)))
        .isFalse();
  }
}
