package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The clients of a {@link NatNetServer}. A flood from false addresses takes nothing from a known
 * client: it keeps its place until it is silent for {@link #SILENCE_NS}, and its requests are always
 * answered. Requests of unknown senders share one rate. Hosts with reserved places share neither rate
 * nor places with others. Pure; one thread at a time.
 */
final class StreamClients {

  /** A client that was silent for this time is removed. */
  static final long SILENCE_NS = 10 * NS_PER_S;

  /** A client that is there sends a message each second. */
  static final long LEAVE_NS = 3 * NS_PER_S;

  /** Largest number of clients, without those of hosts with reserved places. */
  static final int MAX = 64;

  /** Largest number of clients of one host, so that one host cannot take all places. */
  static final int MAX_PER_HOST = MAX / 2;

  /** Requests of unknown senders that are answered in a second; a new client's two are among them. */
  static final int STRANGERS_PER_S = 100;

  private final Map<InetSocketAddress, Long> heardNs = new LinkedHashMap<>();
  private Set<InetAddress> reserved = Set.of();
  private long secondNs = Long.MIN_VALUE;
  private int strangers;

  /** All clients, in the order in which they came. */
  Set<InetSocketAddress> all() {
    return heardNs.keySet();
  }

  /** Sets the hosts that have {@link #MAX_PER_HOST} places each for themselves. */
  void reserve(Set<InetAddress> hosts) {
    reserved = hosts;
  }

  /** Removes silent clients. */
  void removeSilent(long nowNs) {
    heardNs.values().removeIf(lastNs -> nowNs - lastNs > SILENCE_NS);
  }

  /**
   * Removes a client unless it is heard again within {@link #LEAVE_NS}: the message that it leaves may
   * be forged in its name.
   *
   * @return false if there is no such client
   */
  boolean leave(InetSocketAddress client, long nowNs) {
    return heardNs.replace(client, nowNs - SILENCE_NS + LEAVE_NS) != null;
  }

  /** Whether to answer a request of {@code sender}. */
  boolean heard(InetSocketAddress sender, long nowNs) {
    boolean isKnown = heardNs.computeIfPresent(sender, (client, lastNs) -> nowNs) != null;
    if (isKnown || reserved.contains(sender.getAddress())) {
      return true;
    }
    if (secondNs == Long.MIN_VALUE || nowNs - secondNs >= NS_PER_S) {
      secondNs = nowNs;
      strangers = 0;
    }
    strangers = Math.min(strangers + 1, STRANGERS_PER_S + 1);
    return strangers <= STRANGERS_PER_S;
  }

  /** Adds a client; false if there is no place for it. */
  boolean add(InetSocketAddress client, long nowNs) {
    if (!heardNs.containsKey(client) && !hasPlace(client.getAddress())) {
      return false;
    }
    heardNs.put(client, nowNs);
    return true;
  }

  private boolean hasPlace(InetAddress host) {
    int ofHost = 0;
    int unreserved = 0;
    for (InetSocketAddress other : heardNs.keySet()) {
      ofHost += other.getAddress().equals(host) ? 1 : 0;
      unreserved += reserved.contains(other.getAddress()) ? 0 : 1;
    }
    return ofHost < MAX_PER_HOST && (reserved.contains(host) || unreserved < MAX);
  }
}
