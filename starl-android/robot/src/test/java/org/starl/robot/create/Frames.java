package org.starl.robot.create;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Random;
import java.util.Set;

/** Frames with random values, as a robot would send them, and what is in them. */
final class Frames {

  private final int[] packets;
  private final Random random;
  private boolean isLastWhole = true;
  private final Set<String> sent = new LinkedHashSet<>();
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

  Frames(CreateModel model, Random random) {
    this.packets = CreateSensors.packets(model);
    this.random = random;
  }

  /** The next frame, the caller's own. */
  byte[] next() {
    int data = 0;
    for (int packet : packets) {
      data += 1 + Packets.bytes(packet);
    }
    byte[] frame = new byte[data + 3];
    frame[0] = Packets.FRAME_HEADER;
    frame[1] = (byte) data;
    int at = 2;
    StringBuilder text = new StringBuilder();
    for (int packet : packets) {
      frame[at++] = (byte) packet;
      int value = random.nextInt(Packets.bytes(packet) == 2 ? 65536 : 256);
      if (packet == Packets.MODE) {
        value &= 3;
      }
      if (Packets.bytes(packet) == 2) {
        frame[at++] = (byte) (value >> 8);
      }
      frame[at++] = (byte) value;
      text.append(value).append(' ');
    }
    int sum = 0;
    for (byte b : frame) {
      sum += b;
    }
    frame[at] = (byte) -sum;
    sent.add(text.toString());
    return frame;
  }

  /**
   * Puts a frame on the line: whole (true), with a wrong bit, or without its end. After a broken
   * frame comes a whole one: a frame without its end and a wrong header behind it are longer noise,
   * of which one in 256 passes.
   */
  boolean sendPerhapsBroken() {
    byte[] frame = next();
    int fate = isLastWhole ? random.nextInt(3) : 2;
    isLastWhole = fate == 2;
    if (fate == 0) {
      frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(8));
    } else if (fate == 1) {
      frame = Arrays.copyOf(frame, random.nextInt(frame.length));
    }
    line.writeBytes(frame);
    return fate == 2;
  }

  /** All that was put on the line. */
  byte[] line() {
    return line.toByteArray();
  }

  /** All that was in frames so far. */
  Set<String> sent() {
    return sent;
  }

  /** What {@code decoder} took. */
  String text(StreamDecoder decoder) {
    StringBuilder text = new StringBuilder();
    for (int packet : packets) {
      int mask = Packets.bytes(packet) == 2 ? 0xFFFF : 0xFF;
      text.append(decoder.value(packet) & mask).append(' ');
    }
    return text.toString();
  }
}
