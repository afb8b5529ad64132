package org.starl.workload;

import java.util.Map;
import org.junit.jupiter.api.Nested;
import org.starl.sim.fault.Envelope;

/** The contract of {@code MutexPrim}, over both kinds of membership. */
class MutexContractTest {

  @Nested
  class AmongTheRegistered extends PrimitiveContract {
    AmongTheRegistered() {
      super("mutex", Map.of("members", "registered"));
    }
  }

  /** A restarted robot is no member: this one tolerates no crash. */
  @Nested
  class InAFixedGroup extends PrimitiveContract {
    InAFixedGroup() {
      super("mutex", Map.of("members", "fixed"));
    }

    @Override
    Envelope envelope() {
      return Envelope.NETWORK;
    }
  }
}
