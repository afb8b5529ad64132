package org.starl.workload;

import java.util.Map;

/** The contract of {@code SetAgreement}. */
class AgreementContractTest extends PrimitiveContract {
  AgreementContractTest() {
    super("agreement", Map.of());
  }
}
