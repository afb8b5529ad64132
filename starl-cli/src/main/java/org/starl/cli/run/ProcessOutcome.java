package org.starl.cli.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.starl.apps.Measures;
import org.starl.id.RobotId;
import org.starl.launch.LaunchResult;
import org.starl.launch.LaunchResult.Death;
import org.starl.sim.SimResult;
import org.starl.time.Time;

/** The result of robots as processes, as text and JSON. */
public final class ProcessOutcome {

  private ProcessOutcome() {}

  public static List<String> lines(LaunchResult result) {
    SimResult run = result.run();
    List<String> lines = new ArrayList<>();
    int ends = result.rounds().values().stream().mapToInt(Integer::intValue).sum();
    lines.add(
        ("%s processes came %s %s to the end of the app in %s of real time; %s datagrams sent,"
                + " %s copies lost on purpose; longest pause of a program %s ms")
            .formatted(
                result.rounds().size(),
                ends,
                ends == 1 ? "time" : "times",
                Time.text(run.endNs(), 1),
                run.network().sent(),
                run.network().lost(),
                result.longestPauseNs() / Time.NS_PER_MS));
    result.deaths().forEach(death -> lines.add(line(death)));
    for (RobotId robot : run.unfinished()) {
      lines.add(robot + " is alive but not finished: " + why(result));
    }
    if (run.spec().holds()) {
      lines.add("safe: " + Outcome.held(run.spec()));
      lines.addAll(Outcome.unknown(run.spec()));
    }
    lines.addAll(run.spec().exceptions());
    lines.addAll(Outcome.violations(run));
    result.errors().forEach(error -> lines.add("FAILED: " + error));
    if (!result.isGood() && result.deaths().isEmpty()) {
      lines.addAll(Outcome.notFinished(run));
    } else {
      run.diagnosis().lines().forEach(line -> lines.add("  " + line));
    }
    return lines;
  }

  private static String line(Death death) {
    return "%s's process %s %s at %s%s: its body stays where it was, and no robot may enter a zone"
            .formatted(
                death.robot(),
                death.pid(),
                death.isKill() ? "was killed" : "ended by itself",
                Time.text(death.atNs(), 1),
                death.isPlanned() ? ", as requested" : "")
        + " that it may hold";
  }

  private static String why(LaunchResult result) {
    if (result.deaths().isEmpty()) {
      return "the time limit was reached";
    }
    return result.deaths().stream()
        .map(death -> death.robot().name())
        .collect(Collectors.joining(" and ", "it waits for zones that ", " may still hold"));
  }

  static Map<String, Object> json(String app, LaunchResult result, Measures measures) {
    Map<String, Object> json = Outcome.json(app, result.run(), measures);
    json.put("good", result.isGood());
    json.put("safe", result.isSafe());
    Map<String, Object> rounds = new LinkedHashMap<>();
    result.rounds().forEach((robot, count) -> rounds.put(robot.name(), count));
    json.put("rounds", rounds);
    json.put("dead", result.deaths().stream().map(death -> death.robot().name()).toList());
    json.put("errors", result.errors());
    return json;
  }
}
