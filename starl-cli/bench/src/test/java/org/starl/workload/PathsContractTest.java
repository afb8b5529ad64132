package org.starl.workload;

import java.util.Map;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;

/** The contract of {@code DistributedPathPlanning}, over both planners. */
@Tag("long")
class PathsContractTest {

  /** Motion takes long to simulate: few and short runs. */
  private abstract static class Over extends PrimitiveContract {
    Over(String planner) {
      super("paths", Map.of("planner", planner, "rounds", "3", "busy", "6s"));
    }

    @Override
    long seeds() {
      return 1;
    }
  }

  @Nested
  class OverShortestPaths extends Over {
    OverShortestPaths() {
      super("optimal");
    }
  }

  @Nested
  class OverRandomTrees extends Over {
    OverRandomTrees() {
      super("rrt");
    }
  }
}
