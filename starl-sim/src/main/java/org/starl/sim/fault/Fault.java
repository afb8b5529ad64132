package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;

/** A fault and its times. Its text can be read by {@link FaultGrammar#parse}. */
public record Fault(FaultEffect effect, Span span) {

  /**
   * Whether the fault has an end. A crash without restart and the fate of one datagram count as
   * ended at once.
   */
  public boolean isFinite() {
    return span.isFinite() || effect.isSingle();
  }

  /** {@code crash(bot2,at=12s,restart=5s)}. */
  @Override
  public String toString() {
    List<String> arguments = new ArrayList<>(effect.arguments());
    arguments.addAll(span.arguments(effect.lastingKey()));
    return arguments.isEmpty()
        ? effect.name()
        : effect.name() + "(" + String.join(",", arguments) + ")";
  }
}
