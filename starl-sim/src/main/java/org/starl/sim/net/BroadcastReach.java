package org.starl.sim.net;

import java.util.function.Consumer;
import org.starl.id.RobotId;

/**
 * The robots that may receive a broadcast. In large swarms with short range it spares the network the
 * visit of every robot. It may name too many robots, never too few: a {@link LinkRule} decides.
 */
@FunctionalInterface
public interface BroadcastReach {

  /** Names each robot that may hear {@code sender} now, in an order that is the same each run. */
  void forEachHearer(RobotId sender, Consumer<RobotId> hearer);
}
