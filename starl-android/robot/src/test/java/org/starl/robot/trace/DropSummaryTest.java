package org.starl.robot.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.robot.trace.DropSummary.Count;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceSink;

/** A real robot's trace under a flood. */
class DropSummaryTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final long MS = 1_000_000;

  private final List<TraceEvent> recorded = new ArrayList<>();
  private final DropSummary trace = new DropSummary(BOT0, sink());

  private TraceSink sink() {
    return new TraceSink() {
      @Override
      public boolean isOn() {
        return true;
      }

      @Override
      public void record(TraceEvent event) {
        recorded.add(event);
      }
    };
  }

  private List<Count> counts() {
    return recorded.stream()
        .flatMap(event -> event instanceof Action action ? Stream.of(action.fact()) : Stream.of())
        .map(Count.class::cast)
        .toList();
  }

  private static Action said(long timeNs, String word) {
    return Action.of(timeNs, BOT0, Instance.APP, Note.SHAPE, new Note(word, List.of()));
  }

  @Test
  void aFloodLeavesItsFirstDatagramAndOneCountASecond() {
    int flood = 200_000;
    for (int i = 0; i < flood; i++) {
      trace.record(new Dropped(i * 40_000_000_000L / flood, BOT0, "bot1", "a forged seal"));
    }
    trace.flush(40_000 * MS);

    assertThat(recorded).hasSizeLessThan(45).first().isInstanceOf(Dropped.class);
    assertThat(counts().stream().mapToLong(Count::datagrams).sum()).isEqualTo(flood - 1);
    assertThat(counts()).allMatch(count -> count.why().equals("a forged seal"));
  }

  @Test
  void aFloodOfInventedSendersIsBoundedToo() {
    for (int i = 0; i < 100_000; i++) {
      trace.record(new Dropped(i * 10_000L, BOT0, "bot" + i, "a forged seal"));
    }
    assertThat(recorded).hasSizeLessThanOrEqualTo(DropSummary.MAX_SENDERS + 1);
  }

  @Test
  void otherEventsPassInOrderAndCarryTheCounts() {
    Action go = said(5 * MS, "go");
    Action late = said(2000 * MS, "late");
    Dropped first = new Dropped(0, BOT0, "?", "no message");
    trace.record(first);
    trace.record(new Dropped(1, BOT0, "?", "no message"));
    trace.record(go);
    trace.record(late);
    assertThat(recorded)
        .containsExactly(
            first,
            go,
            late,
            Action.of(
                2000 * MS, BOT0, Instance.of("network"), Count.SHAPE, new Count("no message", 1)));
  }
}
