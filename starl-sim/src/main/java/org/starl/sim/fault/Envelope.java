package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;

/**
 * The faults that an app or a primitive tolerates without violating its invariants. Chaos draws from
 * these alone.
 */
public enum Envelope {

  /** No fault. */
  NONE("no faults"),

  /** Faults of the network: loss, bursts, delay, duplication, reordering, partitions. */
  NETWORK("faults of the network: loss, bursts, delay, duplication, reordering, partitions"),

  /**
   * {@link #NETWORK}, and crashes with restarts, with or without the last writes; slow storage,
   * clocks that are wrong without bound, slow computing. For what never relies on time or position
   * for its safety: agreement, registration, election, mutual exclusion, barrier.
   */
  LOGICAL("network, and crashes with restarts, slow storage, slow computing, wrong clocks"),

  /**
   * {@link #LOGICAL}, and an attacker who listens, forges, replays and floods. It needs a key: a run
   * with these faults seals its datagrams.
   */
  HOSTILE("logical, and forged, replayed and random datagrams; seals datagrams with a key"),

  /**
   * {@link #NETWORK}, and crashes with restarts, slow storage, and clocks with up to 200 ppm of
   * drift. For robots that drive by what they agreed on.
   */
  MOVING("network, and crashes with restarts, slow storage, clocks with up to 200 ppm of drift"),

  /** {@link #LOGICAL}, and a minority of the robots crashes without restart. */
  MORTAL("logical, and a minority of the robots crashes without restart"),

  /**
   * {@link #NETWORK}, and bounded physical faults: clocks with up to 200 ppm of drift, fixes with up
   * to 20 mm of additional error that they report, up to a second without fixes, slow and stuck
   * wheels. For what relies on bounded drift and error: geocast, motion, paths.
   */
  SPATIAL("network, and bounded faults of clocks, positioning and wheels");

  private final String meaning;

  Envelope(String meaning) {
    this.meaning = meaning;
  }

  /** One line for users. */
  public String meaning() {
    return meaning;
  }

  /** @throws BadInput if no envelope has this name */
  public static Envelope parse(String text) {
    List<String> names = new ArrayList<>();
    for (Envelope envelope : values()) {
      if (envelope.toString().equals(text.strip())) {
        return envelope;
      }
      names.add(envelope.toString());
    }
    String hint = NearMatches.hint(text.strip(), names);
    throw new BadInput(BadInput.quote(text) + ": no such envelope of faults" + hint);
  }

  /** As in {@code --set chaos=logical}. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
