package org.starl.workload;

import java.util.Map;

/** The contract of {@code RegPrim}. */
class RegistrationContractTest extends PrimitiveContract {
  RegistrationContractTest() {
    super("registration", Map.of());
  }
}
