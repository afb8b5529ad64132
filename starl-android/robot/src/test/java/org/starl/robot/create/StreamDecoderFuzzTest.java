package org.starl.robot.create;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.MalformedBytes;

/**
 * Any bytes from a robot: frames that are taken lie in them, whole, one behind the other; how the bytes
 * are cut into pieces changes nothing; and no driver lets its wheels turn for them.
 */
public class StreamDecoderFuzzTest {

  public static void fuzzerTestOneInput(byte[] input) {
    for (CreateModel model : CreateModel.values()) {
      List<Integer> ends = new ArrayList<>();
      StreamDecoder whole = new StreamDecoder(model, CreateSensors.packets(model));
      whole.accept(input, input.length, decoder -> requireFrame(model, decoder));
      StreamDecoder bytewise = new StreamDecoder(model, CreateSensors.packets(model));
      byte[] one = new byte[1];
      for (int i = 0; i < input.length; i++) {
        one[0] = input[i];
        int end = i + 1;
        bytewise.accept(one, 1, decoder -> ends.add(end));
      }
      require(whole.frames() == ends.size(), "cut otherwise, read otherwise");
      require(whole.dropped() == bytewise.dropped(), "cut otherwise, dropped otherwise");
      int bytes = whole.frameBytes();
      int previous = 0;
      for (int end : ends) {
        require(end - previous >= bytes, "two frames share bytes");
        require(isFrame(input, end - bytes, end), "a frame that is none");
        previous = end;
      }
      long taken = whole.frames() * bytes + whole.dropped();
      require(taken <= input.length && taken > input.length - bytes, "bytes that nobody counted");
      drive(model, input);
    }
  }

  private static void requireFrame(CreateModel model, StreamDecoder decoder) {
    for (int packet : CreateSensors.packets(model)) {
      int value = decoder.value(packet);
      require(value >= -32_768 && value <= 65_535, "packet " + packet + " is " + value);
    }
  }

  private static boolean isFrame(byte[] bytes, int from, int to) {
    int sum = 0;
    for (int i = from; i < to; i++) {
      sum += bytes[i];
    }
    boolean isSum = (sum & 0xFF) == 0 || (sum & 0xFF) == Packets.FRAME_HEADER;
    return isSum
        && bytes[from] == Packets.FRAME_HEADER
        && (bytes[from + 1] & 0xFF) == to - from - 3;
  }

  /** A driver whose program wants nothing never turns a wheel, whatever the robot says. */
  private static void drive(CreateModel model, byte[] input) {
    CreateProtocol driver =
        new CreateProtocol(
            CreateSettings.of(model),
            sent -> {
              boolean isDrive = (sent[0] & 0xFF) == Opcodes.DRIVE_DIRECT;
              require(!isDrive || (sent[1] | sent[2] | sent[3] | sent[4]) == 0, "drives");
              return true;
            });
    driver.linkOpened(0);
    for (long ns = 0; ns < 30 * CreateProtocol.TICK_NS; ns += CreateProtocol.TICK_NS) {
      if (ns % (10 * CreateProtocol.TICK_NS) == 0) {
        driver.received(input, input.length, ns);
      }
      driver.advance(ns);
    }
    driver.status();
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void onlyValidFramesAreAccepted() {
    List<byte[]> samples = new ArrayList<>();
    for (CreateModel model : CreateModel.values()) {
      Frames frames = new Frames(model, new Random(1));
      samples.add(frames.next());
      for (int i = 0; i < 6; i++) {
        frames.sendPerhapsBroken();
      }
      samples.add(frames.line());
    }

    MalformedBytes.feed(samples, StreamDecoderFuzzTest::fuzzerTestOneInput);
  }
}
