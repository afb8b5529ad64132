package org.starl.sim.net;

/**
 * One fault, or one law of the air: says what becomes of a copy. A partition, a limited range, a
 * burst of loss, duplication are rules.
 */
@FunctionalInterface
public interface LinkRule {

  /** Decides about {@code copy}, or passes it on to the next rule and at last to the base link. */
  Verdict judge(Transmission copy);

  /** Takes an installed rule out. */
  @FunctionalInterface
  interface Handle {
    /** From now on the rule judges nothing; what it decided stands. May be called again. */
    void uninstall();
  }
}
