package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;

/** A fault and its times. Its text is what {@link FaultGrammar#parse} reads. */
public record Fault(Harm harm, Span span) {

  public static Fault always(Harm harm) {
    return new Fault(harm, Span.ALWAYS);
  }

  /** Whether it ends. A crash without restart ends at once. */
  public boolean isFinite() {
    return span.isFinite() || harm instanceof Crash;
  }

  /** {@code crash(bot2,at=12s,restart=5s)}. */
  @Override
  public String toString() {
    List<String> arguments = new ArrayList<>(harm.arguments());
    arguments.addAll(span.arguments(harm.lastingKey()));
    return arguments.isEmpty()
        ? harm.name()
        : harm.name() + "(" + String.join(",", arguments) + ")";
  }
}
