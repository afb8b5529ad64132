package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;

/**
 * Which faults an app or a primitive bears without losing its invariants: chaos draws from it, and
 * from nothing else.
 */
public enum Envelope {

  /** No fault. */
  NONE("no faults"),

  /** Whatever a network may do: loss, bursts, delay, duplication, reordering, partitions. */
  NETWORK("whatever a network may do"),

  /**
   * That, and every crash with a restart, with or without its last writes; slow storage, clocks as
   * wrong as can be, computing that takes time. For what never rests its safety on time or place:
   * agreement, registration, election, mutual exclusion, barrier.
   */
  LOGICAL("the network's faults, crashes with restarts, slow storage, wrong clocks"),

  /**
   * As {@link #LOGICAL}, and somebody who listens, forges, replays and floods. Only with a key: a run
   * with these faults seals its datagrams.
   */
  HOSTILE("the logical ones, and forged, replayed and senseless datagrams against a key"),

  /**
   * The network's faults, every crash with a restart, slow storage, and clocks up to 200 ppm off. For
   * robots that drive by what they agreed on.
   */
  MOVING("the network's faults, crashes with restarts, slow storage, clocks up to 200 ppm off"),

  /** As {@link #LOGICAL}, and a minority of the robots that crashes for good. */
  MORTAL("the logical ones, and a minority that crashes for good"),

  /**
   * The network's faults, and what a robot on wheels meets, within bounds: clocks up to 200 ppm off,
   * fixes up to 20 mm farther off and saying so, up to a second without fixes, slow and stuck
   * wheels. For what rests its safety on bounded drift and error: geocast, motion, paths.
   */
  SPATIAL("the network's faults, and bounded ones of clocks, positioning and wheels");

  private final String meaning;

  Envelope(String meaning) {
    this.meaning = meaning;
  }

  /** One line for people. */
  public String meaning() {
    return meaning;
  }

  /** @throws BadInput if no envelope is called so */
  public static Envelope parse(String text) {
    List<String> names = new ArrayList<>();
    for (Envelope envelope : values()) {
      if (envelope.toString().equals(text.strip())) {
        return envelope;
      }
      names.add(envelope.toString());
    }
    String hint = NearMatches.hint(text.strip(), names);
    throw new BadInput(BadInput.quote(text) + ": no envelope of faults is called so" + hint);
  }

  /** As in {@code --set chaos=logical}. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
