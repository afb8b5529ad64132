package org.starl.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Measures;
import org.starl.id.RobotId;
import org.starl.processes.FleetResult;
import org.starl.processes.FleetResult.Death;
import org.starl.sim.SimResult;

/** The result of robots that were processes, as the command line tells it. */
final class ProcessOutcome {

  private ProcessOutcome() {}

  static List<String> lines(FleetResult fleet) {
    SimResult run = fleet.run();
    List<String> lines = new ArrayList<>();
    int ends = 0;
    for (int rounds : fleet.rounds().values()) {
      ends += rounds;
    }
    lines.add(
        fleet.rounds().size()
            + " processes came "
            + ends
            + (ends == 1 ? " time" : " times")
            + " to the end of the app in "
            + Outcome.seconds(run.endNs())
            + " of real time; "
            + run.network().sent()
            + " datagrams sent, "
            + run.network().lost()
            + " copies lost on purpose; longest pause of a program "
            + fleet.longestSilenceNs() / 1_000_000
            + " ms");
    fleet.deaths().forEach(death -> lines.add(line(death)));
    for (RobotId robot : run.unfinished()) {
      lines.add(robot + " lives, and is not through: " + why(fleet));
    }
    if (run.spec().holds()) {
      lines.add("safe: " + Outcome.held(run.spec()));
    }
    run.spec().violations().forEach(violation -> lines.add("VIOLATED: " + violation));
    fleet.errors().forEach(error -> lines.add("FAILED: " + error));
    if (!fleet.isGood() && fleet.deaths().isEmpty() && !run.isFinished()) {
      lines.add("NOT FINISHED: " + run.unfinished());
    }
    return lines;
  }

  private static String line(Death death) {
    String how = death.wasKilled() ? " was killed at " : " ended by itself at ";
    return death.robot()
        + "'s process "
        + death.pid()
        + how
        + Outcome.seconds(death.atNs())
        + (death.wasAsked() ? ", as asked" : "")
        + ": its body stands where it was, and nobody is let in where it may be";
  }

  private static String why(FleetResult fleet) {
    if (fleet.deaths().isEmpty()) {
      return "the time is over";
    }
    List<String> dead = new ArrayList<>();
    fleet.deaths().forEach(death -> dead.add(death.robot().name()));
    return "it waits for what " + String.join(" and ", dead) + " may still hold";
  }

  static Map<String, Object> json(String app, FleetResult fleet, Measures measures) {
    Map<String, Object> json = Outcome.json(app, fleet.run(), measures);
    json.put("good", fleet.isGood());
    json.put("safe", fleet.isSafe());
    Map<String, Object> rounds = new LinkedHashMap<>();
    fleet.rounds().forEach((robot, count) -> rounds.put(robot.name(), count));
    json.put("rounds", rounds);
    json.put("dead", fleet.deaths().stream().map(death -> death.robot().name()).toList());
    json.put("errors", fleet.errors());
    return json;
  }
}
