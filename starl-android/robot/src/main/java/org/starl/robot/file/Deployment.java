package org.starl.robot.file;

import java.io.IOException;
import java.nio.file.Path;
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
import org.starl.input.BadInput;
import org.starl.robot.udp.KeyFile;
import org.starl.robot.udp.PeerKeys;
import org.starl.robot.udp.PublicRobotKey;
import org.starl.robot.udp.RobotKey;

/**
 * The content of a deployment file.
 *
 * @param file its name, for messages
 * @param app the app's name; empty if the file has none: it is chosen on each phone
 * @param seed of the scenario and of the robots' random choices
 * @param parameters of the app and settings of the motion, as texts, in the file's order
 * @param lines the line of each of {@code app}, {@code key}, {@code positions}, {@code world}, {@code
 *     limits} and the parameters
 * @param key path of the file of the one key for all robots, as written; null if there is none
 * @param world address of the process that simulates bodies; null if there is none
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

  /** The same deployment of another app. */
  public Deployment withApp(String newApp) {
    return new Deployment(
        file, newApp, seed, parameters, lines, key, network, positions, robots, world, limits);
  }

  /** All robots. */
  public Participants participants() {
    return Participants.of(new ArrayList<>(robots.keySet()));
  }

  /**
   * The robot of that name.
   *
   * @throws BadInput if there is none; the message lists the robots
   */
  public RobotEntry robot(String name) {
    RobotEntry entry = RobotId.isValid(name) ? robots.get(new RobotId(name)) : null;
    if (entry == null) {
      throw new BadInput(
          file + ": has no robot " + BadInput.quote(name) + "; expected one of " + robots.keySet());
    }
    return entry;
  }

  /** Whether each robot has a key of its own. */
  public boolean hasSeparateKeys() {
    return robots.values().stream().anyMatch(robot -> !robot.publicKeys().isEmpty());
  }

  /** Whether datagrams are sealed. */
  public boolean isSealed() {
    return key != null || hasSeparateKeys();
  }

  /**
   * The keys of one robot with the others; null if datagrams are not sealed.
   *
   * @param secret the file of the robot's secret: its own, or the one of all robots
   * @throws IOException if it cannot be read, others may read it, or it is not this robot's; the
   *     message is one line for people
   */
  public @Nullable PeerKeys keys(RobotEntry robot, Path secret) throws IOException {
    if (key != null) {
      return PeerKeys.shared(KeyFile.read(secret), robot.id(), participants());
    }
    if (!hasSeparateKeys()) {
      return null;
    }
    RobotKey own = RobotKey.read(secret);
    if (!own.isAmong(robot.publicKeys())) {
      throw new IOException(
          secret + ": expected the secret half of robots." + robot.id() + ".publicKey");
    }
    Map<RobotId, List<PublicRobotKey>> published = new TreeMap<>();
    robots.forEach((id, entry) -> published.put(id, entry.publicKeys()));
    return PeerKeys.separate(own, published);
  }

  /** The name of the file with that robot's secret, relative to this file; null if not sealed. */
  public @Nullable String secretOf(RobotEntry robot) {
    return hasSeparateKeys() ? robot.id() + ".key" : key;
  }

  /** The robots whose bodies are in the deployment's world. */
  public List<RobotEntry> simulated() {
    List<RobotEntry> simulated = new ArrayList<>(robots.values());
    simulated.removeIf(robot ->
        robot.wheels() instanceof Wheels.Ros2
            || (robot.wheels() instanceof Wheels.Create create && create.simulatedAt() == null));
    return simulated;
  }

  /** An error in the value of {@code key}. */
  public BadInput error(String key, String value, String expected) {
    return BadInput.at(
        file,
        lines.getOrDefault(key, 1),
        key + ": " + BadInput.quote(value) + ": expected " + expected);
  }

  /** The beginning of an error in {@code key}: {@code my.yaml:3: }. */
  public String where(String key) {
    Integer line = lines.get(key);
    return file + ":" + (line == null ? "" : line + ":") + " ";
  }
}
