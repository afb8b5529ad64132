package org.starl.sim.net;

import java.util.function.Consumer;
import org.starl.id.RobotId;

/**
 * Who can hear a broadcast at all. It spares large swarms with short range the walk over everyone;
 * who is in doubt is named, and a {@link LinkRule} decides.
 */
@FunctionalInterface
public interface Audience {

  /** Names each robot that may hear {@code sender} now, in an order that is the same each run. */
  void forEachHearer(RobotId sender, Consumer<RobotId> hearer);
}
