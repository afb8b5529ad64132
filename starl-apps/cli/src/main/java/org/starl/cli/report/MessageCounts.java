package org.starl.cli.report;

import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;

/** Counts a run's messages by channel, and the dropped copies by cause. */
public final class MessageCounts implements SimObserver {

  /** The counts of one channel. */
  record Channel(long sent, long sentBytes, long delivered) {
    Channel plus(Channel other) {
      return new Channel(
          sent + other.sent, sentBytes + other.sentBytes, delivered + other.delivered);
    }
  }

  private final SortedMap<String, Channel> channels = new TreeMap<>();
  private final SortedMap<String, Long> dropped = new TreeMap<>();

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Sent sent -> add(sent.channel(), new Channel(1, sent.bytes(), 0));
      case TraceEvent.Delivered delivered -> add(delivered.channel(), new Channel(0, 0, 1));
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
    other.channels.forEach(this::add);
    other.dropped.forEach((why, count) -> dropped.merge(why, count, Long::sum));
  }

  private void add(String channel, Channel counts) {
    channels.merge(channel, counts, Channel::plus);
  }
}
