package org.starl.primitives.monitor;

import java.util.List;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.barrier.BarrierFact;
import org.starl.primitives.election.ElectionFact;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.ledger.LedgerFact;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.registration.RegistrationFact;

/** The {@link Phases} of all primitives that send messages. */
public final class PrimitivePhases {

  /** One for each primitive. */
  public static final List<Phases> ALL =
      List.of(
          AgreementFact.PHASES,
          BarrierFact.PHASES,
          ElectionFact.PHASES,
          GeocastFact.PHASES,
          GeocastFact.BROADCAST_PHASES,
          LedgerFact.PHASES,
          MutexFact.PHASES,
          RegistrationFact.PHASES,
          TubeFact.PHASES);

  private PrimitivePhases() {}
}
