package org.starl.cli.report;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;

/** Counts a run's messages by channel, and the dropped copies by cause. */
public final class MessageCounts implements SimObserver {

  /** The counts of one channel. */
  static final class Channel {
    private long sent;
    private long sentBytes;
    private long delivered;

    long sent() {
      return sent;
    }

    long sentBytes() {
      return sentBytes;
    }

    long delivered() {
      return delivered;
    }
  }

  private final SortedMap<String, Channel> channels = new TreeMap<>();
  private final SortedMap<String, Long> dropped = new TreeMap<>();

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Sent sent -> {
        Channel channel = channel(sent.channel());
        channel.sent++;
        channel.sentBytes += sent.bytes();
      }
      case TraceEvent.Delivered delivered -> channel(delivered.channel()).delivered++;
      case TraceEvent.Dropped lost -> dropped.merge(lost.why(), 1L, Long::sum);
      default -> {
        // not a message
      }
    }
  }

  SortedMap<String, Channel> channels() {
    return channels;
  }

  /** The number of dropped copies, by cause. */
  SortedMap<String, Long> dropped() {
    return dropped;
  }

  /** Adds the counts of another run. */
  void add(MessageCounts other) {
    for (Map.Entry<String, Channel> entry : other.channels.entrySet()) {
      Channel sum = channel(entry.getKey());
      sum.sent += entry.getValue().sent;
      sum.sentBytes += entry.getValue().sentBytes;
      sum.delivered += entry.getValue().delivered;
    }
    other.dropped.forEach((why, count) -> dropped.merge(why, count, Long::sum));
  }

  private Channel channel(String name) {
    return channels.computeIfAbsent(name, any -> new Channel());
  }
}
