package org.starl.apps;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;

/** The story of an app without its own: the results of {@code callStarL} on each robot. */
final class Returned implements Story {

  private final SortedMap<RobotId, String> ends = new TreeMap<>();
  private int completed;

  @Override
  public void finished(SimResult result) {
    result
        .results()
        .forEach((robot, returned) ->
            ends.put(
                robot, returned.stream().map(String::valueOf).collect(Collectors.joining(", "))));
    result.unfinished().forEach(robot -> ends.put(robot, "not ended"));
    completed = result.results().size();
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    ends.forEach((robot, end) -> lines.add(robot + ": " + end));
    return lines;
  }

  @Override
  public Measures measures() {
    return new Measures(ends.size(), completed, List.of());
  }
}
