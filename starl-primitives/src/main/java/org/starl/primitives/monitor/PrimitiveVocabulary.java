package org.starl.primitives.monitor;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.barrier.BarrierFact;
import org.starl.primitives.election.ElectionFact;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.ledger.LedgerFact;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.registration.RegistrationFact;
import org.starl.trace.Vocabulary;

/** The {@link Vocabulary} of all primitives, and of what every robot has. */
public final class PrimitiveVocabulary {

  /** All of them. */
  public static final Vocabulary ALL =
      Vocabulary.of(
          List.of(
              GlobalVarHolder.VOCABULARY,
              AgreementFact.VOCABULARY,
              BarrierFact.VOCABULARY,
              ElectionFact.VOCABULARY,
              GeocastFact.VOCABULARY,
              LedgerFact.VOCABULARY,
              MutexFact.VOCABULARY,
              RegistrationFact.VOCABULARY,
              TubeFact.VOCABULARY));

  private PrimitiveVocabulary() {}
}
