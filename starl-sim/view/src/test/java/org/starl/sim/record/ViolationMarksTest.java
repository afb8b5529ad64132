package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.shape.Shapes;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

/** Pictures of a violation show where it is, and of which robots. */
class ViolationMarksTest {

  private static final RobotId A = new RobotId("bot0");
  private static final RobotId B = new RobotId("bot1");
  private static final long S = 1_000_000_000;
  private static final int FLOOR_PX = 900;
  private static final int WHOLE_PX = 1420;

  /** The text of a violation is below. */
  private static final int MARKS_PX = 850;

  private static final Var<String> MODE = Var.of("mode", Shapes.TEXT);

  private static final Region ZONE = new Circle(new Point(0, 0), 900);

  private static void begin(SimObserver recorder, String title) {
    recorder.started(new TraceHeader("0", title, 7, 8, Map.of(), List.of(A, B)));
    recorder.observed(new TraceEvent.Joined(0, A, new Pose(0, 0, 0), 165));
    recorder.observed(new TraceEvent.Joined(0, B, new Pose(3000, 0, 0), 165));
  }

  static Failure violation(long atNs, Region region, RobotId... robots) {
    return new Failure(
        Failure.Kind.VIOLATED,
        "alone",
        "",
        "alone violated",
        atNs,
        Stream.of(robots).map(robot -> new Failure.Culprit(robot, null, Deviation.NONE)).toList(),
        region,
        List.of(),
        "",
        List.of());
  }

  private static BufferedImage picture(Failure violation) throws IOException {
    PictureRecorder recorder =
        new PictureRecorder(Obstacles.NONE, Layer.NONE, new PictureTime.Violation());
    begin(recorder, "a");
    recorder.wentWrong(violation);
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    recorder.writePng(png);
    return ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
  }

  /** Number of pixels in the colour of violations, from x to x. */
  private static int marked(BufferedImage picture, int fromPx, int toPx) {
    int count = 0;
    for (int x = fromPx; x < toPx; x++) {
      for (int y = 0; y < MARKS_PX; y++) {
        count += picture.getRGB(x, y) == Theme.LIGHT.alarm().getRGB() ? 1 : 0;
      }
    }
    return count;
  }

  @Test
  void theRobotsOfAViolationHaveRings() throws IOException {
    BufferedImage ofA = picture(violation(0, new Nowhere(), A));
    assertThat(marked(ofA, 0, FLOOR_PX / 2)).isPositive();
    assertThat(marked(ofA, FLOOR_PX / 2, FLOOR_PX)).isZero();
    BufferedImage ofB = picture(violation(0, new Nowhere(), B));
    assertThat(marked(ofB, 0, FLOOR_PX / 2)).isZero();
    assertThat(marked(ofB, FLOOR_PX / 2, FLOOR_PX)).isPositive();
  }

  @Test
  void theRegionOfAViolationIsOutlined() throws IOException {
    int ring = marked(picture(violation(0, new Nowhere(), A)), 0, FLOOR_PX);
    int both = marked(picture(violation(0, ZONE, A)), 0, FLOOR_PX);
    assertThat(both).isGreaterThan(2 * ring);
  }

  @Test
  void aPictureOfAFilmIsMarkedAlsoIfTheViolationIsFoundLater() throws IOException {
    for (long otherNs : new long[] {0, 1}) {
      Filmstrip film = new Filmstrip(Obstacles.NONE, Layer.NONE, List.of(S));
      begin(film, "a");
      film.observed(new TraceEvent.Variable(2 * S, A, Instance.APP, MODE, "ON"));
      film.wentWrong(violation(S + otherNs, ZONE, A));
      film.cut();
      ByteArrayOutputStream png = new ByteArrayOutputStream();
      film.frames().get(0).writePng(WHOLE_PX, png);
      BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
      assertThat(marked(picture, 0, FLOOR_PX) > 0).isEqualTo(otherNs == 0);
    }
  }

  @Test
  void aLongTitleIsNotCut() throws IOException {
    PictureRecorder recorder =
        new PictureRecorder(Obstacles.NONE, Layer.NONE, new PictureTime.Violation());
    begin(recorder, "org.example.".repeat(12) + "DockTest#robotsTakeTurns");
    recorder.wentWrong(violation(0, ZONE, A));
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    recorder.writePng(png);
    BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png.toByteArray()));
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = WHOLE_PX - 8; x < WHOLE_PX; x++) {
        assertThat(picture.getRGB(x, y)).isEqualTo(Theme.LIGHT.paper().getRGB());
      }
    }
  }
}
