package org.starl.workload;

import java.util.Map;

/** The contract of {@code Geocast} and {@code Broadcast}. */
class GeocastContractTest extends PrimitiveContract {
  GeocastContractTest() {
    super("geocast", Map.of());
  }
}
