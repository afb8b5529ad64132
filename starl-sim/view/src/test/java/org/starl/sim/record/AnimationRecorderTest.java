package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.jcodec.api.FrameGrab;
import org.jcodec.common.io.ByteBufferSeekableByteChannel;
import org.jcodec.common.model.Picture;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.AnimationRecorder.Kind;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

class AnimationRecorderTest {

  private static final RobotId ROBOT = new RobotId("bot0");
  private static final long S = 1_000_000_000;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private AnimationRecorder recorder(boolean ofViolation) {
    return recorder(Kind.GIF, ofViolation);
  }

  private AnimationRecorder recorder(Kind kind, boolean ofViolation) {
    AnimationRecorder recorder =
        new AnimationRecorder(kind, out, Obstacles.NONE, Layer.NONE, S, 100, ofViolation);
    recorder.started(new TraceHeader("0", "a", 7, 8, Map.of(), List.of(ROBOT)));
    recorder.observed(new TraceEvent.Joined(0, ROBOT, new Pose(0, 0, 0), 165));
    return recorder;
  }

  private static void goTo(long timeNs, AnimationRecorder recorder) {
    recorder.observed(new TraceEvent.Moved(timeNs, ROBOT, new Pose(0, 0, 0), 1, 1));
  }

  private int frames() throws IOException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(out.toByteArray())));
    return reader.getNumImages(true);
  }

  @Test
  void framesAreWrittenDuringTheRun() throws IOException {
    AnimationRecorder recorder = recorder(false);
    goTo(5 * S, recorder);
    int bytes = out.size();
    assertThat(bytes).isGreaterThan(1000);
    goTo(9 * S, recorder);
    assertThat(out.size()).isGreaterThan(bytes);
    recorder.close();
    assertThat(frames()).isEqualTo(9);
  }

  @Test
  void aViolationHasTheFramesAroundIt() throws IOException {
    AnimationRecorder recorder = recorder(true);
    goTo(100 * S, recorder);
    assertThat(out.size()).isZero();
    recorder.wentWrong(ViolationMarksTest.violation(100 * S, new Nowhere(), ROBOT));
    goTo(200 * S, recorder);
    recorder.close();
    assertThat(frames()).isEqualTo(60 + 20);
  }

  @Test
  void withoutTheViolationNothingIsWritten() throws IOException {
    AnimationRecorder recorder = recorder(true);
    goTo(100 * S, recorder);
    recorder.close();
    assertThat(out.size()).isZero();
  }

  /** What a decoder sees of a video is what the GIF shows, nearly. */
  @Test
  void aVideoHasTheSameFrames() throws Exception {
    AnimationRecorder gif = recorder(false);
    goTo(9 * S, gif);
    gif.close();
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(out.toByteArray())));
    BufferedImage expected = reader.read(8);
    out.reset();
    AnimationRecorder video = recorder(Kind.MP4, false);
    goTo(9 * S, video);
    video.close();
    FrameGrab frames =
        FrameGrab.createFrameGrab(
            ByteBufferSeekableByteChannel.readFromByteBuffer(ByteBuffer.wrap(out.toByteArray())));
    Picture last = frames.getNativeFrame();
    int count = 0;
    for (Picture next = last; next != null; next = frames.getNativeFrame()) {
      last = next;
      count++;
    }
    assertThat(count).isEqualTo(9);
    assertThat(last.getCroppedWidth()).isEqualTo(expected.getWidth() & ~1);
    assertThat(last.getCroppedHeight()).isEqualTo(expected.getHeight() & ~1);
    double difference = 0;
    int pixels = 0;
    for (int y = 0; y < last.getCroppedHeight(); y++) {
      for (int x = 0; x < last.getCroppedWidth(); x++) {
        int rgb = expected.getRGB(x, y);
        double luma = 0.299 * (rgb >> 16 & 0xFF) + 0.587 * (rgb >> 8 & 0xFF) + 0.114 * (rgb & 0xFF);
        difference += Math.abs(luma - shown(last.getPlaneData(0)[y * last.getWidth() + x] + 128));
        pixels++;
      }
    }
    assertThat(difference / pixels).as("mean difference of brightness").isLessThan(8);
  }

  /** The brightness that a player shows for a value of a video: 16 is black, 235 is white. */
  private static double shown(int value) {
    return Math.clamp((value - 16) * 255.0 / 219, 0, 255);
  }
}
