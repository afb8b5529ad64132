package org.starl.cli;

import java.util.List;
import org.starl.cli.report.Report;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/** A specification that every run of hello violates: no robot drives. */
public final class StandsStill implements Monitor {
  @Override
  public List<String> lemmas() {
    return List.of("stands_still");
  }

  @Override
  public String description(String lemma) {
    return "No robot drives.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof TraceEvent.Moved moved && moved.linearMmPerS() != 0) {
      report.violated("stands_still", event.timeNs(), List.of(event.robot()), "drives");
    }
  }
}
