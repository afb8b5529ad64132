package org.starl.sim.net;

/**
 * A rule of the network: passes, delays, repeats or drops each copy of a datagram. Faults
 * such as a partition, a limited range or bursts of loss are rules.
 */
@FunctionalInterface
public interface LinkRule {

  /** Decides about {@code copy}, or passes it on to the next rule and at last to the base link. */
  Verdict judge(Transmission copy);

  /** Removes an installed rule. */
  @FunctionalInterface
  interface Handle {
    /** Removes the rule; its earlier decisions stand. May be called again. */
    void uninstall();
  }
}
