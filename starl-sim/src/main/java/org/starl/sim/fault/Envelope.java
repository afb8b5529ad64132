package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;

/**
 * The faults that an app or a primitive tolerates without violating its invariants. Chaos draws
 * only from these.
 */
public enum Envelope {

  /** No fault. */
  NONE("no faults"),

  /** Faults of the network: loss, bursts, delay, duplication, reordering, partitions. */
  NETWORK("faults of the network: loss, bursts, delay, duplication, reordering, partitions"),

  /**
   * {@link #NETWORK}, and crashes with restarts, with or without the last writes; slow storage,
   * unbounded clock errors, slow computing. For primitives whose safety does not depend on time or
   * position: agreement, registration, election, mutual exclusion, barrier.
   */
  LOGICAL("network, and crashes with restarts, slow storage, slow computing, wrong clocks"),

  /**
   * {@link #LOGICAL}, and an attacker that listens, forges, replays and floods. A run with these
   * faults seals its datagrams with a key.
   */
  HOSTILE("logical, and forged, replayed and random datagrams; seals datagrams with a key"),

  /**
   * {@link #NETWORK}, and crashes with restarts, slow storage, clocks with up to 200 ppm of drift,
   * and fixes with up to 20 mm of additional, reported error. For robots that drive according to an
   * agreement.
   */
  MOVING("network, and crashes with restarts, slow storage, bounded errors of clocks and fixes"),

  /** {@link #LOGICAL}, and permanent crashes of a minority of the robots. */
  MORTAL("logical, and a minority of the robots crashes without restart"),

  /**
   * {@link #NETWORK}, and bounded physical faults: clocks with up to 200 ppm of drift, one of them up
   * to 20 ms off, fixes with up to 20 mm of additional, reported error, up to a second without fixes,
   * slow and stuck wheels.
   * For apps that rely on bounded drift and error, and survive no crash.
   */
  SPATIAL("network, and bounded faults of clocks, positioning and wheels"),

  /** {@link #SPATIAL}, and crashes with restarts, slow storage: for primitives of moving robots. */
  PHYSICAL("spatial, and crashes with restarts, slow storage"),

  /**
   * {@link #PHYSICAL}, and up to 10 s without fixes, with fixes that may be far off and say so, or with
   * fixes that are far off and do not say so; then without crashes, as a robot believes its first fix.
   * For robots that must notice that they do not know where they are.
   */
  UNLOCATED("physical, and seconds without fixes, with vague ones or with wrong ones");

  private final String meaning;

  Envelope(String meaning) {
    this.meaning = meaning;
  }

  /** Whether robots crash and restart. */
  public boolean hasCrashes() {
    return this != NONE && this != NETWORK && this != SPATIAL;
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

  /** The name as in {@code --set chaos=logical}. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
