package org.starl.workload;

import java.util.Map;

/** The contract of {@code LedgerPrim}. */
class LedgerContractTest extends PrimitiveContract {
  LedgerContractTest() {
    super("ledger", Map.of());
  }
}
