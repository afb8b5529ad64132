package org.starl.robot.udp;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * Counts of a radio's datagrams.
 *
 * @param sent datagrams given to the network, one for each recipient
 * @param unsent datagrams without a known recipient, or refused by the network
 * @param received datagrams handed to the strand
 * @param dropped received datagrams that were dropped, by reason; reasons without any are left out
 */
public record UdpStatistics(long sent, long unsent, long received, Map<UdpDrop, Long> dropped) {

  public UdpStatistics {
    dropped = Collections.unmodifiableMap(new TreeMap<>(dropped));
  }

  /** Number of datagrams dropped for this reason. */
  public long dropped(UdpDrop reason) {
    return dropped.getOrDefault(reason, 0L);
  }
}
