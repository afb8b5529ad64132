package org.starl.processes;

import org.starl.id.RobotId;

/** What a parent tells a child, one line each. */
sealed interface Order {

  /** Time is 0 at {@code originNs} of the machine's clock: open a radio, and say its port. */
  record Begin(long originNs) implements Order {
    @Override
    public String toString() {
      return "begin " + originNs;
    }
  }

  /** Another robot is to be reached there. */
  record Peer(RobotId robot, int port) implements Order {
    @Override
    public String toString() {
      return "peer " + robot + " " + port;
    }
  }

  /** All peers are told: run. */
  record Go() implements Order {
    @Override
    public String toString() {
      return "go";
    }
  }

  /** There is room for the body that waits for its place on the floor. */
  record Place() implements Order {
    @Override
    public String toString() {
      return "place";
    }
  }

  /** No more orders: end. */
  record End() implements Order {}

  /** The app has come to its end; said by the child itself. */
  record Finished() implements Order {}

  /**
   * Reads a line.
   *
   * @throws IllegalArgumentException if it is none of the first four
   */
  static Order parse(String line) {
    String[] words = line.split(" ", -1);
    try {
      return switch (words[0] + words.length) {
        case "begin2" -> new Begin(Long.parseLong(words[1]));
        case "peer3" -> new Peer(new RobotId(words[1]), Integer.parseInt(words[2]));
        case "go1" -> new Go();
        case "place1" -> new Place();
        default -> throw new IllegalArgumentException("expected begin, peer, go or place");
      };
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("no order: '" + line + "'", e);
    }
  }
}
