package org.starl.robot.file;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * What a deployment file says.
 *
 * @param file its name, for messages
 * @param app by its name
 * @param seed of the scenario and of the robots' draws
 * @param parameters of the app and settings of the motion, as texts, in the file's order
 * @param lines where each of {@code app}, {@code key}, {@code positions}, {@code world}, {@code
 *     limits} and the parameters stands
 * @param key path of the key's file, as written; null: datagrams are not sealed
 * @param world where the process of the simulated bodies is asked for places; null if there is none
 */
public record Deployment(
    String file,
    String app,
    long seed,
    Map<String, String> parameters,
    Map<String, Integer> lines,
    @Nullable String key,
    Network network,
    Positions positions,
    SortedMap<RobotId, RobotEntry> robots,
    @Nullable HostPort world,
    Limits limits) {

  public Deployment {
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    lines = Collections.unmodifiableMap(new LinkedHashMap<>(lines));
    robots = Collections.unmodifiableSortedMap(new TreeMap<>(robots));
  }

  /** All robots. */
  public Participants participants() {
    return Participants.of(new ArrayList<>(robots.keySet()));
  }

  /**
   * The robot of that name.
   *
   * @throws DeploymentException if there is none, naming those that there are
   */
  public RobotEntry robot(String name) {
    RobotEntry entry = RobotId.isValid(name) ? robots.get(new RobotId(name)) : null;
    if (entry == null) {
      throw new DeploymentException(
          file + ": has no robot '" + name + "'; expected one of " + robots.keySet());
    }
    return entry;
  }

  /** The robots whose bodies are in the deployment's world. */
  public List<RobotEntry> simulated() {
    List<RobotEntry> simulated = new ArrayList<>();
    for (RobotEntry robot : robots.values()) {
      boolean isReal =
          robot.wheels() instanceof Wheels.Create create && create.simulatedAt() == null;
      if (!isReal) {
        simulated.add(robot);
      }
    }
    return simulated;
  }

  /** What stands before an error in {@code key}: {@code my.yaml:3: }. */
  public String where(String key) {
    Integer line = lines.get(key);
    return file + ":" + (line == null ? "" : line + ":") + " ";
  }
}
