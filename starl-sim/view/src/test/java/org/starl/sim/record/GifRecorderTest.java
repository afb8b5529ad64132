package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

class GifRecorderTest {

  private static final RobotId ROBOT = new RobotId("bot0");
  private static final long S = 1_000_000_000;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private GifRecorder recorder(boolean ofViolation) {
    GifRecorder recorder = new GifRecorder(out, Obstacles.NONE, Layer.NONE, S, 100, ofViolation);
    recorder.started(new TraceHeader("0", "a", 7, 8, Map.of(), List.of(ROBOT)));
    recorder.observed(new TraceEvent.Joined(0, ROBOT, new Pose(0, 0, 0), 165));
    return recorder;
  }

  private static void goTo(long timeNs, GifRecorder recorder) {
    recorder.observed(new TraceEvent.Moved(timeNs, ROBOT, new Pose(0, 0, 0), 1, 1));
  }

  private int frames() throws IOException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(out.toByteArray())));
    return reader.getNumImages(true);
  }

  @Test
  void framesAreWrittenDuringTheRun() throws IOException {
    GifRecorder recorder = recorder(false);
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
    GifRecorder recorder = recorder(true);
    goTo(100 * S, recorder);
    assertThat(out.size()).isZero();
    recorder.wentWrong(ViolationMarksTest.violation(100 * S, new Nowhere(), ROBOT));
    goTo(200 * S, recorder);
    recorder.close();
    assertThat(frames()).isEqualTo(60 + 20);
  }

  @Test
  void withoutTheViolationNothingIsWritten() throws IOException {
    GifRecorder recorder = recorder(true);
    goTo(100 * S, recorder);
    recorder.close();
    assertThat(out.size()).isZero();
  }
}
