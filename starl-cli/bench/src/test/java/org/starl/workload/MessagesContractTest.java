package org.starl.workload;

import java.util.Map;

/** The contract of {@code gvh.comms}. */
class MessagesContractTest extends PrimitiveContract {
  MessagesContractTest() {
    super("messages", Map.of());
  }
}
