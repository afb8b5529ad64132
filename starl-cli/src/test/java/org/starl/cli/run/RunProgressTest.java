package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;
import org.starl.cli.command.ProgressLine;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

class RunProgressTest {

  private static final long S = 1_000_000_000;

  private final StringWriter out = new StringWriter();
  private long nowNs;

  /** Events of 100 simulated seconds, of which each takes so many ns. */
  private void run(boolean isTerminal, long perSecondNs) {
    PrintWriter err = new PrintWriter(out, true);
    ProgressLine line =
        new ProgressLine(err, "simulated seconds at most", isTerminal, 120, () -> nowNs);
    RunProgress progress = new RunProgress(line, 200 * S);
    for (int second = 1; second <= 100; second++) {
      nowNs += perSecondNs;
      for (int i = 0; i < 1000; i++) {
        progress.observed(new TraceEvent.Left(second * S, new RobotId("bot0")));
      }
    }
    progress.end();
    err.println("next");
  }

  @Test
  void aLongRunShowsItsSimulatedTime() {
    run(false, S / 4);
    assertThat(out.toString().lines())
        .containsExactly(
            "20 of 200 simulated seconds at most; 4.0 per second, 45 s left",
            "40 of 200 simulated seconds at most; 4.0 per second, 40 s left",
            "60 of 200 simulated seconds at most; 4.0 per second, 35 s left",
            "80 of 200 simulated seconds at most; 4.0 per second, 30 s left",
            "100 of 200 simulated seconds at most; 4.0 per second, 25 s left",
            "next");
  }

  @Test
  void aShortRunShowsNoProgress() {
    run(false, S / 100);
    run(true, S / 100);
    assertThat(out.toString().lines()).containsExactly("next", "next");
  }

  @Test
  void outputAfterTheProgressBeginsANewLine() {
    run(true, S / 2);
    assertThat(out.toString()).contains("[###############...............] 100 of 200");
    assertThat(out.toString().lines().reduce((a, b) -> b)).contains("next");
  }
}
