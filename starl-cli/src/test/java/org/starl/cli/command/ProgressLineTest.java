package org.starl.cli.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class ProgressLineTest {

  private static final long S = 1_000_000_000;

  private final StringWriter out = new StringWriter();
  private long nowNs;

  @Test
  void tenPlainLinesShowTheRemainingTime() {
    ProgressLine line = line(false);
    for (int finished = 1; finished <= 200; finished++) {
      nowNs += S / 4;
      line.advanced(finished, 200, finished / 100);
    }
    line.end();
    assertThat(out.toString().lines())
        .hasSize(10)
        .contains("20 of 200 runs, 0 bad; 4.0 per second, 45 s left")
        .contains("100 of 200 runs, 1 bad; 4.0 per second, 25 s left")
        .contains("200 of 200 runs, 2 bad; 4.0 per second");
  }

  @Test
  void plainLinesAreAtMostTenSecondsApart() {
    ProgressLine line = line(false);
    for (int second = 1; second <= 60; second++) {
      nowNs += S;
      line.advanced(second / 20, 1_000_000, 0);
      assertThat(out.toString().lines().count()).isGreaterThanOrEqualTo(second / 10);
    }
    assertThat(out.toString().lines())
        .hasSizeLessThan(10)
        .startsWith("0 of 1000000 runs, 0 bad")
        .contains("1 of 1000000 runs, 0 bad; 2.2 per minute, 7499 h 59 min left");
  }

  @Test
  void aSeedThatStillRunsAfterFiveSecondsIsNamedOnce() {
    ProgressLine line = line(false);
    for (int second = 0; second < 30; second++) {
      // Seed 7 does not end; each other one takes 2 s.
      line.running(new TreeSet<>(List.of(7L, 8L + second / 2)));
      if (second < 5) {
        assertThat(out.toString()).isEmpty();
      }
      nowNs += S;
    }
    assertThat(out.toString().lines()).containsExactly("seed 7 still runs after 5 s");
  }

  @Test
  void slowWorkHasARatePerHour() {
    ProgressLine line = line(false);
    nowNs += 90 * S;
    line.advanced(1, 10, 0);
    nowNs += 10_000 * S;
    line.advanced(2, 10, 0);
    assertThat(out.toString().lines())
        .containsExactly(
            "1 of 10 runs, 0 bad; 40 per hour, 13 min 30 s left",
            "2 of 10 runs, 0 bad; 0.7 per hour, 11 h 12 min left");
  }

  @Test
  void aTerminalShowsOneLineRedrawnAtMostTenTimesPerSecond() {
    ProgressLine line = line(true);
    for (int finished = 1; finished <= 1000; finished++) {
      nowNs += S / 100;
      line.advanced(finished, 1000, 0);
    }
    line.end();
    assertThat(out.toString().lines()).hasSize(101 + 1);
    assertThat(out.toString())
        .endsWith(
            "\r[##############################] 1000 of 1000 runs, 0 bad; 100 per second"
                + " ".repeat(", 1 s left".length() - "0".length())
                + System.lineSeparator());
  }

  @Test
  void theBarFitsTheTerminal() {
    for (int columns : new int[] {20, 60, 80}) {
      ProgressLine line =
          new ProgressLine(new PrintWriter(out, true), "runs", true, columns, () -> nowNs);
      for (int finished = 1; finished <= 1000; finished += 10) {
        nowNs += S;
        line.advanced(finished, 1000, 0);
      }
      line.end();
      assertThat(out.toString().split("[\r\n]+"))
          .allMatch(drawn -> drawn.stripTrailing().length() < columns);
      out.getBuffer().setLength(0);
    }
  }

  @Test
  void aNoteTakesTheBarsPlace() {
    ProgressLine line = line(true);
    line.advanced(500, 1000, 1);
    line.note("seed 7: violated");
    assertThat(out.toString()).endsWith("\rseed 7: violated" + System.lineSeparator());
  }

  private ProgressLine line(boolean isTerminal) {
    return new ProgressLine(new PrintWriter(out, true), "runs", isTerminal, 120, () -> nowNs);
  }
}
