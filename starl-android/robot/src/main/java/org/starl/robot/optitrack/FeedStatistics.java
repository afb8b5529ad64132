package org.starl.robot.optitrack;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * Counts of a feed.
 *
 * @param received datagrams
 * @param fixes of bodies, also of bodies that no robot follows
 * @param dropped datagrams or bodies not used, by the reason
 */
public record FeedStatistics(long received, long fixes, Map<FeedDrop, Long> dropped) {

  public FeedStatistics {
    dropped = Collections.unmodifiableMap(new TreeMap<>(dropped));
  }

  public long dropped(FeedDrop why) {
    return dropped.getOrDefault(why, 0L);
  }
}
