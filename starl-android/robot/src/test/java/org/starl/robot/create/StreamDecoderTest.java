package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

/** Whatever bytes come, only frames that the robot sent are taken, and all of those that are whole. */
class StreamDecoderTest {

  /** Cliff front left, as in the specifications' example, and virtual wall. */
  private static final int[] EXAMPLE = {29, 13};

  private final List<String> taken = new ArrayList<>();

  @Test
  void theExampleOfTheCreate2SpecificationIsDecoded() {
    StreamDecoder decoder = new StreamDecoder(CreateModel.CREATE_2, EXAMPLE);
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    assertThat(taken).containsExactly("537,0");
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 182);
    assertThat(taken).hasSize(1);
    assertThat(decoder.badChecksums()).isEqualTo(1);
    assertThat(decoder.dropped()).isEqualTo(8);
  }

  @Test
  void aCreate1UsesTheRuleOfThreeFrames() {
    StreamDecoder decoder = new StreamDecoder(CreateModel.CREATE_1, EXAMPLE);
    for (int frame = 0; frame < 3; frame++) {
      assertThat(taken).isEmpty();
      accept(decoder, 19, 5, 29, 2, 25, 13, 0, 182);
    }
    assertThat(taken).containsExactly("537,0");
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    assertThat(taken).hasSize(1);
    decoder.reset();
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 182);
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    assertThat(taken).hasSize(1);
    accept(decoder, 19, 5, 29, 2, 25, 13, 0, 163);
    assertThat(taken).hasSize(2);
  }

  @Test
  void aFrameThatBeginsInsideAFalseOneIsFound() {
    StreamDecoder decoder = new StreamDecoder(CreateModel.CREATE_2, EXAMPLE);
    accept(decoder, 19, 5, 29, 19, 5, 29, 2, 25, 13, 0, 163);
    accept(decoder, 19, 19, 5, 19, 5, 29, 2, 26, 13, 0, 162);
    assertThat(taken).containsExactly("537,0", "538,0");
    assertThat(decoder.dropped()).isEqualTo(6);
  }

  @Property(tries = 2000)
  void changedAndTruncatedFramesAreRefused(@ForAll CreateModel model, @ForAll long seed) {
    Random random = new Random(seed);
    Frames frames = new Frames(model, random);
    int whole = 0;
    for (int i = 0; i < 20; i++) {
      whole += frames.sendPerhapsBroken() ? 1 : 0;
    }
    StreamDecoder decoder = new StreamDecoder(model, CreateSensors.packets(model));
    List<String> heard = new ArrayList<>();
    decoder.accept(frames.line(), frames.line().length, d -> heard.add(frames.text(d)));
    assertThat(frames.sent()).as("seed " + seed).containsAll(heard);
    if (model == CreateModel.CREATE_2) {
      assertThat(heard).as("seed " + seed).hasSizeGreaterThanOrEqualTo(whole);
    }
  }

  @Property(tries = 1000)
  @Tag("long")
  void theNextCompleteFrameAfterNoiseIsAccepted(@ForAll @Size(max = 200) byte[] noise) {
    Frames frames = new Frames(CreateModel.CREATE_2, new Random(noise.length));
    StreamDecoder decoder =
        new StreamDecoder(CreateModel.CREATE_2, CreateSensors.packets(CreateModel.CREATE_2));
    List<String> heard = new ArrayList<>();
    decoder.accept(noise, noise.length, d -> heard.add(frames.text(d)));
    byte[] frame = frames.next();
    decoder.accept(frame, frame.length, d -> heard.add(frames.text(d)));
    assertThat(heard).containsExactlyElementsOf(frames.sent());
  }

  private void accept(StreamDecoder decoder, int... bytes) {
    byte[] line = new byte[bytes.length];
    for (int i = 0; i < bytes.length; i++) {
      line[i] = (byte) bytes[i];
    }
    decoder.accept(line, line.length, d -> taken.add(d.value(29) + "," + d.value(13)));
  }
}
