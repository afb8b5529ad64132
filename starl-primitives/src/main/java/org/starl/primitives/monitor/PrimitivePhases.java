package org.starl.primitives.monitor;

import java.util.List;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.BarrierTrace;
import org.starl.primitives.election.ElectionTrace;
import org.starl.primitives.geocast.GeocastTrace;
import org.starl.primitives.mutex.MutexTrace;
import org.starl.primitives.paths.TubeTrace;
import org.starl.primitives.registration.RegistrationTrace;

/** The {@link Phases} of all primitives that send messages. */
public final class PrimitivePhases {

  /** One for each primitive. */
  public static final List<Phases> ALL =
      List.of(
          SetAgreement.PHASES,
          BarrierTrace.PHASES,
          ElectionTrace.PHASES,
          GeocastTrace.PHASES,
          GeocastTrace.BROADCAST_PHASES,
          MutexTrace.PHASES,
          RegistrationTrace.PHASES,
          TubeTrace.PHASES);

  private PrimitivePhases() {}
}
