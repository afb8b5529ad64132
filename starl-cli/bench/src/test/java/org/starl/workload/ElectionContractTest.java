package org.starl.workload;

import java.util.Map;
import org.junit.jupiter.api.Nested;

/** The contract of {@code ElectionPrim}, by both strategies. */
class ElectionContractTest {

  @Nested
  class RandomBallot extends PrimitiveContract {
    RandomBallot() {
      super("election", Map.of("strategy", "random"));
    }
  }

  @Nested
  class Bully extends PrimitiveContract {
    Bully() {
      super("election", Map.of("strategy", "bully"));
    }
  }
}
