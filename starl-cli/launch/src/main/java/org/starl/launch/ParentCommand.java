package org.starl.launch;

import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.id.RobotId;

/** A parent's command to a robot's process: one line on its standard input. */
sealed interface ParentCommand {

  /** Open the radio and report its port; time 0 is {@code originNs} on the machine's clock. */
  record Begin(long originNs) implements ParentCommand {
    @Override
    public String toString() {
      return "begin " + originNs;
    }
  }

  /** Run; the other robots' radios listen at these ports of the loopback interface. */
  record Go(SortedMap<RobotId, Integer> ports) implements ParentCommand {
    @Override
    public String toString() {
      return ports.entrySet().stream()
          .map(peer -> " " + peer.getKey() + " " + peer.getValue())
          .collect(Collectors.joining("", "go", ""));
    }
  }

  /** Put the waiting body on the floor: there is room. */
  record Place() implements ParentCommand {
    @Override
    public String toString() {
      return "place";
    }
  }

  /**
   * Reads a line.
   *
   * @throws IllegalArgumentException if it is not a command
   */
  static ParentCommand parse(String line) {
    String[] words = line.split(" ", -1);
    try {
      if (words[0].equals("begin") && words.length == 2) {
        return new Begin(Long.parseLong(words[1]));
      } else if (words[0].equals("go") && words.length % 2 == 1) {
        SortedMap<RobotId, Integer> ports = new TreeMap<>();
        for (int i = 1; i < words.length; i += 2) {
          ports.put(new RobotId(words[i]), Integer.parseInt(words[i + 1]));
        }
        return new Go(ports);
      } else if (line.equals("place")) {
        return new Place();
      }
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("not a command: '" + line + "'", e);
    }
    throw new IllegalArgumentException(
        "not a command: '" + line + "'; expected begin, go or place");
  }
}
