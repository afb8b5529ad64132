package org.starl.cli;

import java.io.PrintWriter;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.kernel.CarrierKind;

/** Which carriers to run on. */
final class Carriers {

  private Carriers() {}

  /** What the user wants, else the best; one line says why that is not the fast one. */
  static CarrierKind chosen(@Nullable CarrierKind wanted, PrintWriter err) {
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
