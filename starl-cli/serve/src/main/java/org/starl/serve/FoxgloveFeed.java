package org.starl.serve;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.jspecify.annotations.Nullable;
import org.starl.cli.serve.Site;
import org.starl.sim.export.FoxgloveRecorder;
import org.starl.sim.export.MessageSink;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/**
 * One client of Foxglove's WebSocket protocol
 * (github.com/foxglove/ws-protocol, docs/spec.md): {@code foxglove.websocket.v1}, and {@code
 * foxglove.sdk.v1}, which is the same on the wire. The client gets the latest message of each topic
 * that it subscribes to, and then each message as the run goes on; a run that is over is played from
 * its start in real time. A client that reads too slowly loses messages, and is told how many.
 */
final class FoxgloveFeed implements MessageSink {

  /** Either of these; the server answers with the first that a client offers. */
  static final List<String> PROTOCOLS = List.of("foxglove.websocket.v1", "foxglove.sdk.v1");

  /** Messages on the way to the client. */
  private static final int MOST_OUTSTANDING = 512;

  private static final byte MESSAGE_DATA = 1;
  private static final byte TIME = 2;
  private static final int WARNING = 1;

  /** A message, and the time of its channel. */
  private record Latest(long timeNs, ByteBuffer json) {}

  private final Session session;
  private final Recording recording;
  private final FoxgloveRecorder recorder;
  private final ObjectMapper mapper = new ObjectMapper();
  private final SortedMap<Integer, Latest> latest = new TreeMap<>();

  /** The client's number of the subscription to each channel. */
  private final SortedMap<Integer, Long> subscriptions = new TreeMap<>();

  private final PriorityQueue<Mark> untold =
      new PriorityQueue<>(Comparator.comparingLong(Mark::timeNs));

  private final AtomicInteger outstanding = new AtomicInteger();
  private final boolean isPlayed;
  private int channels;
  private int events;
  private int marks;
  private long playedNs;
  private boolean hasBegun;
  private long dropped;
  private long toldDropped;

  FoxgloveFeed(Session session, Site.Shown shown) {
    this.session = session;
    recording = shown.recording();
    isPlayed = recording.isOver();
    recorder = new FoxgloveRecorder(recording.obstacles(), new Cursor(recording).layer(), this);
    send(
        Map.of(
            "op", "serverInfo",
            "name", "StarL: " + shown.title(),
            "capabilities", List.of("time"),
            "supportedEncodings", List.of("json"),
            "metadata", Map.of()));
  }

  /** Sends what is new; {@code elapsedNs} after the last call. */
  synchronized void advance(long elapsedNs) {
    if (!recording.hasBegun()) {
      return;
    }
    if (!hasBegun) {
      hasBegun = true;
      recorder.started(recording.header());
    }
    playedNs = isPlayed ? Math.min(playedNs + elapsedNs, recording.endNs()) : recording.endNs();
    int until = isPlayed ? recording.firstAfter(playedNs) : recording.size();
    for (; events < until; events++) {
      recorder.observed(recording.event(events));
    }
    recorder.advance(events == 0 ? 0 : Math.max(recording.timeNs(events - 1), playedNs - 1));
    tellViolations();
    if (outstanding.get() < MOST_OUTSTANDING) {
      ByteBuffer time = ByteBuffer.allocate(9).order(ByteOrder.LITTLE_ENDIAN);
      send(time.put(TIME).putLong(playedNs).flip());
    }
    tellDropped();
  }

  /** Marks are in the order in which they were found, which is not that of their times. */
  private void tellViolations() {
    List<Mark> all = recording.marks();
    for (; marks < all.size(); marks++) {
      if (all.get(marks).kind() == Mark.Kind.VIOLATION) {
        untold.add(all.get(marks));
      }
    }
    for (Mark next = untold.peek();
        next != null && next.timeNs() <= playedNs;
        next = untold.peek()) {
      recorder.alarm(untold.remove().text());
    }
  }

  private void tellDropped() {
    if (dropped > toldDropped && outstanding.get() == 0) {
      toldDropped = dropped;
      String told = dropped + " messages were dropped so far: the connection is too slow";
      send(Map.of("op", "status", "level", WARNING, "message", told));
    }
  }

  @Override
  public int channel(String topic, Schema schema) {
    channels++;
    Map<String, Object> channel =
        Map.of(
            "id",
            channels,
            "topic",
            topic,
            "encoding",
            "json",
            "schemaName",
            schema.name(),
            "schema",
            schema.json(),
            "schemaEncoding",
            "jsonschema");
    send(Map.of("op", "advertise", "channels", List.of(channel)));
    return channels;
  }

  @Override
  public void message(int channel, long timeNs, ObjectNode message) {
    Latest last = new Latest(timeNs, ByteBuffer.wrap(MessageSink.bytes(mapper, message)));
    latest.put(channel, last);
    offer(channel, last);
  }

  private void offer(int channel, Latest message) {
    Long subscription = subscriptions.get(channel);
    if (subscription == null) {
      return;
    }
    if (outstanding.get() >= MOST_OUTSTANDING) {
      dropped++;
      return;
    }
    ByteBuffer json = message.json.duplicate();
    ByteBuffer data = ByteBuffer.allocate(13 + json.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    data.put(MESSAGE_DATA).putInt((int) (long) subscription).putLong(message.timeNs).put(json);
    send(data.flip());
  }

  /**
   * Takes a message of the client.
   *
   * @return why it cannot be understood; null if it can
   */
  synchronized @Nullable String received(String text) {
    JsonNode read;
    try {
      read = mapper.readTree(text);
    } catch (JsonProcessingException e) {
      return "expected JSON";
    }
    switch (read.path("op").asText()) {
      case "subscribe" -> read.path("subscriptions").forEach(this::subscribe);
      case "unsubscribe" ->
          read.path("subscriptionIds")
              .forEach(id -> subscriptions.values().removeIf(own -> own == id.asLong()));
      default -> {
        return "op: expected subscribe or unsubscribe";
      }
    }
    return null;
  }

  private void subscribe(JsonNode subscription) {
    int channel = subscription.path("channelId").asInt();
    if (channel < 1 || channel > channels) {
      return;
    }
    subscriptions.put(channel, subscription.path("id").asLong());
    Latest last = latest.get(channel);
    if (last != null) {
      offer(channel, last);
    }
  }

  private void send(Map<String, ?> message) {
    try {
      outstanding.incrementAndGet();
      session.sendText(mapper.writeValueAsString(message), sent());
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a message that is not JSON", e);
    }
  }

  private void send(ByteBuffer data) {
    outstanding.incrementAndGet();
    session.sendBinary(data, sent());
  }

  private Callback sent() {
    return Callback.from(outstanding::decrementAndGet, error -> outstanding.decrementAndGet());
  }
}
