package org.starl.workload;

import java.util.Map;

/** The contract of {@code BarrierPrim}. */
class BarrierContractTest extends PrimitiveContract {
  BarrierContractTest() {
    super("barrier", Map.of());
  }
}
