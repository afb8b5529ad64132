package org.starl.cli.report;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;

/** Counts a run's messages by channel, and what came to nothing by its cause. */
public final class MessageCounts implements SimObserver {

  /** What went over one channel. */
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
        // No message.
      }
    }
  }

  SortedMap<String, Channel> channels() {
    return channels;
  }

  /** How many copies, by the cause. */
  SortedMap<String, Long> dropped() {
    return dropped;
  }

  /** Takes over what another run counted. */
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
