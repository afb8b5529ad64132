package org.starl.robot.udp;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;

/**
 * What a radio has sent and heard.
 *
 * @param sent datagrams given to the network, one for each recipient
 * @param unsent those that had no known recipient, or that the network refused
 * @param received datagrams handed to the strand
 * @param dropped those that came and were dropped, by reason; reasons without any are not there
 */
public record UdpStatistics(long sent, long unsent, long received, Map<UdpDrop, Long> dropped) {

  public UdpStatistics {
    Map<UdpDrop, Long> copy = new EnumMap<>(UdpDrop.class);
    copy.putAll(dropped);
    dropped = Collections.unmodifiableMap(copy);
  }

  /** How many were dropped for this reason. */
  public long dropped(UdpDrop reason) {
    return dropped.getOrDefault(reason, 0L);
  }
}
