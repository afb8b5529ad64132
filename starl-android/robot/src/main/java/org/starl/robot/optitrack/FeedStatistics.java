package org.starl.robot.optitrack;

import java.util.Map;

/**
 * What a feed has heard.
 *
 * @param received datagrams
 * @param fixes of bodies, whether or not anybody asked for them
 * @param dropped datagrams or bodies not used, by the reason
 */
public record FeedStatistics(long received, long fixes, Map<FeedDrop, Long> dropped) {

  public FeedStatistics {
    dropped = Map.copyOf(dropped);
  }

  public long dropped(FeedDrop why) {
    return dropped.getOrDefault(why, 0L);
  }
}
