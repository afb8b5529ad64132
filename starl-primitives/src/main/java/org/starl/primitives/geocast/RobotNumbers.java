package org.starl.primitives.geocast;

import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.id.RobotId;

/**
 * Numbers robots from 0 in the order in which they appear, so that a set of robots can be a set of
 * bits: each of thousands of geocasts has several sets of up to all robots.
 */
final class RobotNumbers {

  private final Map<RobotId, Integer> numbers = new LinkedHashMap<>();

  int of(RobotId robot) {
    Integer known = numbers.get(robot);
    if (known == null) {
      known = numbers.size();
      numbers.put(robot, known);
    }
    return known;
  }
}
