package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;

/** Messages between robots, time running down. */
class SequenceChartTest {

  private static final long MS = 1_000_000;
  private static final Pattern ROW =
      Pattern.compile(
          "<g class=\"(row[^\"]*)\" transform=\"translate\\(0,(\\d+)\\)\" data-ms=\"([0-9.]+)\"");
  private static final Pattern ARROW =
      Pattern.compile(
          "<line class=\"(?:msg|lost)\" x1=\"\\d+\" y1=\"(\\d+)\" x2=\"\\d+\" y2=\"(\\d+)\"");

  private static RobotId bot(int number) {
    return new RobotId("bot" + number);
  }

  @Property(tries = 100)
  void eachMessageHasARowOfItsOwnAndTheLastOneToACulpritIsEmphasised(
      @ForAll @Size(min = 1, max = 30) List<@IntRange(max = 3) Integer> senders,
      @ForAll @Size(30) List<@IntRange(max = 3) Integer> receivers,
      @ForAll @Size(30) List<Boolean> isLost) {
    SequenceChart chart = new SequenceChart(1000);
    List<String> decisive = new ArrayList<>();
    for (int i = 0; i < senders.size(); i++) {
      RobotId from = bot(senders.get(i));
      RobotId to = bot(receivers.get(i));
      Instance channel = Instance.of("p", "i");
      chart.observed(
          new Sent(10 * i * MS, from, to.name(), channel, i, 9, Shapes.TEXT, "<q" + i + ">"));
      if (isLost.get(i)) {
        chart.observed(new Dropped((10 * i + 5) * MS, to, from.name(), "loss"));
      } else {
        chart.observed(
            new Delivered((10 * i + 5) * MS, to, from, channel, i, Shapes.TEXT, "<q" + i + ">"));
        if (to.equals(bot(0))) {
          decisive = List.of(10 * i + 5 + ".0");
        }
      }
    }
    chart.decide(List.of(bot(0)), Long.MAX_VALUE);
    chart.end("something went wrong");
    String svg = chart.svg();
    List<MatchResult> rows = ROW.matcher(svg).results().toList();
    List<Integer> heights = rows.stream().map(row -> Integer.valueOf(row.group(2))).toList();
    assertThat(rows).hasSameSizeAs(senders);
    assertThat(heights).doesNotHaveDuplicates().isSorted();
    assertThat(ARROW.matcher(svg).results())
        .hasSameSizeAs(senders)
        .allMatch(arrow -> arrow.group(1).equals(arrow.group(2)));
    assertThat(rows.stream().filter(row -> row.group(1).contains("decisive")))
        .extracting(row -> row.group(3))
        .isEqualTo(decisive);
    assertThat(svg).doesNotContain("<q").contains("something went wrong");
  }

  private record Word(String from, String text) {
    static final RecordShape<Word> SHAPE =
        Shapes.of(
            Word.class,
            Shapes.part("from", Shapes.TEXT, Word::from),
            Shapes.part("text", Shapes.TEXT, Word::text),
            Word::new);
  }

  @Test
  void aRecordIsShownWithoutItsSenderAndATextAsItIs() {
    SequenceChart chart = new SequenceChart();
    Instance channel = Instance.of("p", "i");
    chart.observed(
        new Delivered(0, bot(1), bot(2), channel, 1, Word.SHAPE, new Word("bot2", "to=A, b")));
    chart.observed(new Delivered(0, bot(1), bot(2), channel, 2, Shapes.TEXT, "go to=A, b"));
    chart.decide(List.of(bot(1)), Long.MAX_VALUE);
    chart.end("something went wrong");
    assertThat(chart.svg()).contains(">Word[text=to=A, b]<title>", ">go to=A, b<title>");
  }

  @Property(tries = 20)
  void aViolationEndsTheChart(@ForAll @IntRange(min = 1, max = 100) int before) {
    SequenceChart chart = new SequenceChart();
    for (int i = 0; i < 2 * before; i++) {
      if (i == before) {
        chart.violated(new SpecReport.Violation("L", i * MS, List.of(bot(1)), "two"));
      }
      chart.observed(
          new Delivered(i * MS, bot(1), bot(2), Instance.of("p", "i"), i, Shapes.TEXT, "m" + i));
    }
    List<MatchResult> rows = ROW.matcher(chart.svg()).results().toList();
    assertThat(rows).hasSize(Math.min(60, before));
    assertThat(rows.getLast().group(1)).isEqualTo("row decisive");
    assertThat(rows.getLast().group(3)).isEqualTo(before - 1 + ".0");
  }
}
