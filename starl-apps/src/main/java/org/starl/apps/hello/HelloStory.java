package org.starl.apps.hello;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Story;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.sim.SimResult;

/** The result of each robot's motion. */
final class HelloStory implements Story {

  private final SortedMap<RobotId, String> ends = new TreeMap<>();

  @Override
  public void finished(SimResult result) {
    result.results().forEach((robot, ended) -> ends.put(robot, String.valueOf(ended.get(0))));
    result.unfinished().forEach(robot -> ends.put(robot, "not ended"));
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    ends.forEach((robot, end) -> lines.add(robot + ": " + end));
    return lines;
  }

  @Override
  public Measures measures() {
    int done = Collections.frequency(ends.values(), MotionFlag.DONE.name());
    return new Measures(ends.size(), done, List.of());
  }
}
