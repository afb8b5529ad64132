package org.starl.workload;

import java.util.Map;

/** The contract of {@code MotionPrim}. */
class MotionContractTest extends PrimitiveContract {
  MotionContractTest() {
    super("motion", Map.of());
  }
}
