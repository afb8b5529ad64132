package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
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

  /** The counts so far, as a row of a shard has them. */
  record Counts(SortedMap<String, Channel> channels, SortedMap<String, Long> dropped) {}

  private final SortedMap<String, Channel> channels = new TreeMap<>();
  private final SortedMap<String, Long> dropped = new TreeMap<>();

  public MessageCounts() {}

  @JsonCreator(mode = JsonCreator.Mode.DELEGATING)
  MessageCounts(Counts counts) {
    channels.putAll(counts.channels);
    dropped.putAll(counts.dropped);
  }

  @JsonValue
  Counts counts() {
    return new Counts(channels, dropped);
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Sent sent -> add(sent.channel().name(), new Channel(1, sent.bytes(), 0));
      case TraceEvent.Delivered delivered -> add(delivered.channel().name(), new Channel(0, 0, 1));
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
