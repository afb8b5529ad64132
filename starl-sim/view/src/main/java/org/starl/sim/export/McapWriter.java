package org.starl.sim.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes messages of many channels into one MCAP file (mcap.dev/spec, version 0), which tools can
 * search by time: chunks in LZ4, an index of each chunk, and statistics at the end. Written
 * by hand: no Java library writes MCAP. Times are in ns and do not decrease.
 */
final class McapWriter implements MessageSink, RosBag.Encoded, Closeable {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
  private static final int CHUNK_BYTES = 1 << 20;

  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int CHUNK = 0x06;
  private static final int MESSAGE_INDEX = 0x07;
  private static final int CHUNK_INDEX = 0x08;
  private static final int STATISTICS = 0x0B;
  private static final int SUMMARY_OFFSET = 0x0E;
  private static final int DATA_END = 0x0F;
  private static final int METADATA = 0x0C;
  private static final int METADATA_INDEX = 0x0D;
  private static final String COMPRESSION = "lz4";

  /** A message in the index of its chunk. */
  private record Place(long timeNs, long offset) {}

  private final ObjectMapper json = new ObjectMapper();
  private final OutputStream out;
  private final boolean isRos;
  private long position;

  private final McapBytes record = new McapBytes();
  private final McapBytes schemas = new McapBytes();
  private final McapBytes channels = new McapBytes();
  private final McapBytes chunkIndexes = new McapBytes();
  private final McapBytes chunk = new McapBytes();
  private final SortedMap<Integer, List<Place>> chunkPlaces = new TreeMap<>();
  private long chunkStartNs;
  private long chunkEndNs;

  private final SortedMap<Integer, Long> messagesOfChannel = new TreeMap<>();
  private final SortedMap<String, Integer> schemaNumbers = new TreeMap<>();
  private final McapBytes metadataIndexes = new McapBytes();
  private int metadataCount;
  private int chunkCount;
  private long messageCount;
  private long startNs;
  private long endNs;

  /**
   * @param library name of the writing program
   * @param isRos messages are in CDR with ROS 2's definitions; else in JSON with JSON schemas
   */
  McapWriter(OutputStream out, String library, boolean isRos) {
    this.out = out;
    this.isRos = isRos;
    write(MAGIC, MAGIC.length);
    record.text(isRos ? "ros2" : "");
    record.text(library);
    write(HEADER, record);
  }

  /** Adds facts about the whole run, by name. */
  void metadata(String name, Map<String, String> facts) {
    McapBytes entries = new McapBytes();
    facts.forEach((key, value) -> {
      entries.text(key);
      entries.text(value);
    });
    record.reset();
    record.text(name);
    record.u32(entries.size());
    record.raw(entries);
    long at = position;
    write(METADATA, record);
    long length = position - at;
    record.reset();
    record.u64(at);
    record.u64(length);
    record.text(name);
    metadataIndexes.record(METADATA_INDEX, record);
    metadataCount++;
  }

  private int schema(String name, String definition) {
    int schemaCount = schemaNumbers.size() + 1;
    record.reset();
    record.u16(schemaCount);
    record.text(name);
    record.text(isRos ? "ros2msg" : "jsonschema");
    record.text(definition);
    schemas.record(SCHEMA, record);
    chunk.record(SCHEMA, record);
    return schemaCount;
  }

  @Override
  public int channel(String topic, Schema schema) {
    return channel(topic, schema.name(), schema.json());
  }

  @Override
  public int channel(String topic, String schemaName, String definition) {
    int schema =
        schemaNumbers.computeIfAbsent(
            schemaName + " " + definition, any -> schema(schemaName, definition));
    int channel = messagesOfChannel.size() + 1;
    messagesOfChannel.put(channel, 0L);
    record.reset();
    record.u16(channel);
    record.u16(schema);
    record.text(topic);
    record.text(isRos ? "cdr" : "json");
    record.u32(0); // no metadata
    channels.record(CHANNEL, record);
    chunk.record(CHANNEL, record);
    return channel;
  }

  @Override
  public void message(int channel, long timeNs, ObjectNode message) {
    message(channel, timeNs, MessageSink.bytes(json, message));
  }

  /** Adds a message, not earlier than the previous one. */
  @Override
  public void message(int channel, long timeNs, byte[] message) {
    if (timeNs < endNs) {
      throw new IllegalArgumentException("a message at " + timeNs + " ns after one at " + endNs);
    }
    if (messageCount == 0) {
      startNs = timeNs;
    }
    if (chunkPlaces.isEmpty()) {
      chunkStartNs = timeNs;
    }
    endNs = timeNs;
    chunkEndNs = timeNs;
    chunkPlaces
        .computeIfAbsent(channel, any -> new ArrayList<>())
        .add(new Place(timeNs, chunk.size()));
    long sequence = messagesOfChannel.merge(channel, 1L, Long::sum);
    messageCount++;
    record.reset();
    record.u16(channel);
    record.u32(sequence);
    record.u64(timeNs);
    record.u64(timeNs);
    record.writeBytes(message);
    chunk.record(MESSAGE, record);
    if (chunk.size() >= CHUNK_BYTES) {
      endChunk();
    }
  }

  private void endChunk() {
    if (chunk.size() == 0) {
      return;
    }
    long chunkAt = position;
    CRC32 crc = new CRC32();
    crc.update(chunk.array(), 0, chunk.size());
    record.reset();
    record.u64(chunkStartNs);
    record.u64(chunkEndNs);
    record.u64(chunk.size());
    record.u32(crc.getValue());
    byte[] compressed = Lz4Frame.of(chunk.array(), chunk.size());
    record.text(COMPRESSION);
    record.u64(compressed.length);
    record.writeBytes(compressed);
    write(CHUNK, record);
    long chunkLength = position - chunkAt;
    McapBytes offsets = new McapBytes();
    long indexesAt = position;
    for (var places : chunkPlaces.entrySet()) {
      offsets.u16(places.getKey());
      offsets.u64(position);
      writeIndex(places.getKey(), places.getValue());
    }
    record.reset();
    record.u64(chunkStartNs);
    record.u64(chunkEndNs);
    record.u64(chunkAt);
    record.u64(chunkLength);
    record.u32(offsets.size());
    record.raw(offsets);
    record.u64(position - indexesAt);
    record.text(COMPRESSION);
    record.u64(compressed.length);
    record.u64(chunk.size());
    chunkIndexes.record(CHUNK_INDEX, record);
    chunkCount++;
    chunk.reset();
    chunkPlaces.clear();
  }

  private void writeIndex(int channel, List<Place> places) {
    record.reset();
    record.u16(channel);
    record.u32(16L * places.size());
    for (Place place : places) {
      record.u64(place.timeNs);
      record.u64(place.offset);
    }
    write(MESSAGE_INDEX, record);
  }

  /** Writes the last chunk and the summary, and closes the stream. */
  @Override
  public void close() throws IOException {
    try (out) {
      endChunk();
      record.reset();
      record.u32(0); // no checksum of the data
      write(DATA_END, record);
      writeSummary();
      write(MAGIC, MAGIC.length);
    }
  }

  private void writeSummary() {
    long summaryAt = position;
    McapBytes offsets = new McapBytes();
    writeGroup(SCHEMA, schemas, offsets);
    writeGroup(CHANNEL, channels, offsets);
    McapBytes statistics = new McapBytes();
    record.reset();
    record.u64(messageCount);
    record.u16(schemaNumbers.size());
    record.u32(messagesOfChannel.size());
    record.u32(0); // attachments
    record.u32(metadataCount);
    record.u32(chunkCount);
    record.u64(startNs);
    record.u64(endNs);
    record.u32(10L * messagesOfChannel.size());
    messagesOfChannel.forEach((channel, count) -> {
      record.u16(channel);
      record.u64(count);
    });
    statistics.record(STATISTICS, record);
    writeGroup(STATISTICS, statistics, offsets);
    writeGroup(CHUNK_INDEX, chunkIndexes, offsets);
    writeGroup(METADATA_INDEX, metadataIndexes, offsets);
    long offsetsAt = position;
    write(offsets.array(), offsets.size());
    record.reset();
    record.u64(summaryAt);
    record.u64(offsetsAt);
    record.u32(0); // no checksum of the summary
    write(FOOTER, record);
  }

  private void writeGroup(int kind, McapBytes group, McapBytes offsets) {
    if (group.size() == 0) {
      return;
    }
    record.reset();
    record.u8(kind);
    record.u64(position);
    record.u64(group.size());
    offsets.record(SUMMARY_OFFSET, record);
    write(group.array(), group.size());
  }

  private void write(int kind, McapBytes content) {
    McapBytes whole = new McapBytes();
    whole.record(kind, content);
    write(whole.array(), whole.size());
  }

  private void write(byte[] bytes, int length) {
    try {
      out.write(bytes, 0, length);
    } catch (IOException e) {
      throw new UncheckedIOException("the MCAP file cannot be written", e);
    }
    position += length;
  }

  /** A growing buffer in MCAP's encoding: little endian; texts and records follow their lengths. */
  private static final class McapBytes extends ByteArrayOutputStream {

    /** The buffer itself, not a copy; the first {@link #size} bytes are valid. */
    byte[] array() {
      return buf;
    }

    void u8(int value) {
      number(value, 1);
    }

    void u16(int value) {
      number(value, 2);
    }

    void u32(long value) {
      number(value, 4);
    }

    void u64(long value) {
      number(value, 8);
    }

    void text(String text) {
      byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
      u32(utf8.length);
      writeBytes(utf8);
    }

    void record(int kind, McapBytes content) {
      u8(kind);
      u64(content.size());
      raw(content);
    }

    void raw(McapBytes from) {
      write(from.buf, 0, from.count);
    }

    private void number(long value, int bytes) {
      for (int i = 0; i < bytes; i++) {
        write((int) (value >>> (8 * i)));
      }
    }
  }
}
