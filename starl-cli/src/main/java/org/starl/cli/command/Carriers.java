package org.starl.cli.command;

import java.io.PrintWriter;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.kernel.CarrierKind;

/** Selects the carriers of blocking apps. */
public final class Carriers {

  private Carriers() {}

  /** The wanted kind; without one the best kind, with a line if that is not the fast one. */
  public static CarrierKind select(@Nullable CarrierKind wanted, PrintWriter err) {
    String reason = CarrierKind.fallbackReason();
    if (wanted == null) {
      if (reason != null) {
        err.println("starl: " + reason);
      }
      return CarrierKind.best();
    }
    if (wanted == CarrierKind.VIRTUAL && reason != null) {
      throw new BadInput("--carrier virtual: " + reason);
    }
    return wanted;
  }
}
