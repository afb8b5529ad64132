package org.starl.sim.export;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes messages of many channels into one file that can be searched by time: the MCAP container
 * (mcap.dev/spec, version 0), in uncompressed chunks, each with an index, and with statistics at
 * the end. Does not interpret the messages. Times are in ns and must not decrease.
 */
final class McapWriter implements Closeable {

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

  /** One message in the index of its chunk. */
  private record Place(long timeNs, long offset) {}

  private final OutputStream out;
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
  private int schemaCount;
  private int chunkCount;
  private long messageCount;
  private long startNs;
  private long endNs;

  /**
   * @param library name of the writing library, for information
   */
  McapWriter(OutputStream out, String library) throws IOException {
    this.out = out;
    write(MAGIC, MAGIC.length);
    record.clear();
    record.text("");
    record.text(library);
    write(HEADER, record);
  }

  /**
   * Adds a schema of messages.
   *
   * @param jsonSchema the schema
   * @return the schema's number, for {@link #channel}
   */
  int schema(String name, String jsonSchema) {
    schemaCount++;
    record.clear();
    record.u16(schemaCount);
    record.text(name);
    record.text("jsonschema");
    record.text(jsonSchema);
    schemas.record(SCHEMA, record);
    chunk.record(SCHEMA, record);
    return schemaCount;
  }

  /** Opens a channel; the result is its number, for {@link #message}. */
  int channel(int schema, String topic) {
    int channel = messagesOfChannel.size() + 1;
    messagesOfChannel.put(channel, 0L);
    record.clear();
    record.u16(channel);
    record.u16(schema);
    record.text(topic);
    record.text("json");
    record.u32(0); // no metadata
    channels.record(CHANNEL, record);
    chunk.record(CHANNEL, record);
    return channel;
  }

  /** Adds a message, not earlier than the one before. */
  void message(int channel, long timeNs, byte[] json) throws IOException {
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
        .add(new Place(timeNs, chunk.length()));
    long sequence = messagesOfChannel.merge(channel, 1L, Long::sum);
    messageCount++;
    record.clear();
    record.u16(channel);
    record.u32(sequence);
    record.u64(timeNs);
    record.u64(timeNs);
    record.raw(json, json.length);
    chunk.record(MESSAGE, record);
    if (chunk.length() >= CHUNK_BYTES) {
      endChunk();
    }
  }

  private void endChunk() throws IOException {
    if (chunk.length() == 0) {
      return;
    }
    long chunkAt = position;
    CRC32 crc = new CRC32();
    crc.update(chunk.array(), 0, chunk.length());
    record.clear();
    record.u64(chunkStartNs);
    record.u64(chunkEndNs);
    record.u64(chunk.length());
    record.u32(crc.getValue());
    record.text(""); // no compression
    record.u64(chunk.length());
    record.raw(chunk.array(), chunk.length());
    write(CHUNK, record);
    long chunkLength = position - chunkAt;
    McapBytes offsets = new McapBytes();
    long indexesAt = position;
    for (var places : chunkPlaces.entrySet()) {
      offsets.u16(places.getKey());
      offsets.u64(position);
      writeIndex(places.getKey(), places.getValue());
    }
    record.clear();
    record.u64(chunkStartNs);
    record.u64(chunkEndNs);
    record.u64(chunkAt);
    record.u64(chunkLength);
    record.u32(offsets.length());
    record.raw(offsets.array(), offsets.length());
    record.u64(position - indexesAt);
    record.text("");
    record.u64(chunk.length());
    record.u64(chunk.length());
    chunkIndexes.record(CHUNK_INDEX, record);
    chunkCount++;
    chunk.clear();
    chunkPlaces.clear();
  }

  private void writeIndex(int channel, List<Place> places) throws IOException {
    record.clear();
    record.u16(channel);
    record.u32(16L * places.size());
    for (Place place : places) {
      record.u64(place.timeNs);
      record.u64(place.offset);
    }
    write(MESSAGE_INDEX, record);
  }

  /** Writes what is left, and closes the stream. */
  @Override
  public void close() throws IOException {
    try (out) {
      endChunk();
      record.clear();
      record.u32(0); // no checksum over all
      write(DATA_END, record);
      writeSummary();
      write(MAGIC, MAGIC.length);
    }
  }

  private void writeSummary() throws IOException {
    long summaryAt = position;
    McapBytes offsets = new McapBytes();
    writeGroup(SCHEMA, schemas, offsets);
    writeGroup(CHANNEL, channels, offsets);
    McapBytes statistics = new McapBytes();
    record.clear();
    record.u64(messageCount);
    record.u16(schemaCount);
    record.u32(messagesOfChannel.size());
    record.u32(0); // attachments
    record.u32(0); // metadata
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
    long offsetsAt = position;
    write(offsets.array(), offsets.length());
    record.clear();
    record.u64(summaryAt);
    record.u64(offsetsAt);
    record.u32(0); // no checksum over the summary
    write(FOOTER, record);
  }

  private void writeGroup(int kind, McapBytes group, McapBytes offsets) throws IOException {
    if (group.length() == 0) {
      return;
    }
    record.clear();
    record.u8(kind);
    record.u64(position);
    record.u64(group.length());
    offsets.record(SUMMARY_OFFSET, record);
    write(group.array(), group.length());
  }

  private void write(int kind, McapBytes content) throws IOException {
    McapBytes whole = new McapBytes();
    whole.record(kind, content);
    write(whole.array(), whole.length());
  }

  private void write(byte[] bytes, int length) throws IOException {
    out.write(bytes, 0, length);
    position += length;
  }

  /** Bytes as MCAP has them: the lowest first, texts and records behind their lengths. */
  private static final class McapBytes {
    private byte[] bytes = new byte[256];
    private int length;

    byte[] array() {
      return bytes;
    }

    int length() {
      return length;
    }

    void clear() {
      length = 0;
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
      raw(utf8, utf8.length);
    }

    void record(int kind, McapBytes content) {
      u8(kind);
      u64(content.length);
      raw(content.bytes, content.length);
    }

    void raw(byte[] from, int count) {
      reserve(count);
      System.arraycopy(from, 0, bytes, length, count);
      length += count;
    }

    private void number(long value, int count) {
      reserve(count);
      for (int i = 0; i < count; i++) {
        bytes[length++] = (byte) (value >>> (8 * i));
      }
    }

    private void reserve(int count) {
      if (length + count > bytes.length) {
        bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + count));
      }
    }
  }
}
