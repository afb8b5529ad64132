package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.LightColour;
import org.starl.LightControl;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** The robots' lights in pictures. */
class LightsTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final int SIZE_PX = 100;
  private static final Viewport VIEWPORT = new Viewport(SIZE_PX, SIZE_PX, new Point(0, 0), 0.1);

  /** A place 1.25 radii from the robot's centre. */
  private static final int BESIDE_PX = SIZE_PX / 2 + 25;

  private final Scene scene = new Scene(Obstacles.NONE);

  /** The colour beside the robot after its variable has had this value. */
  private <T> Color beside(Var<T> variable, T colour) {
    scene.observe(new TraceEvent.Joined(0, BOT, new Pose(0, 0, 0), 200));
    scene.observe(new TraceEvent.Variable(0, BOT, LightControl.SOURCE, variable, colour));
    BufferedImage image = new BufferedImage(SIZE_PX, SIZE_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    new Painter().paint(page, scene, Layer.NONE, VIEWPORT, Look.FILE, List.of());
    page.dispose();
    return new Color(image.getRGB(SIZE_PX / 2, BESIDE_PX));
  }

  private static Color paper() {
    return Look.FILE.theme().paper();
  }

  @Test
  void aRobotWhoseLightIsOnStandsInItsColour() {
    Color beside = beside(LightControl.COLOUR, new LightColour(0xFF0000));
    assertThat(beside.getRed())
        .isGreaterThan(beside.getGreen() + 50)
        .isGreaterThan(beside.getBlue() + 50);
  }

  @Test
  void aLightThatIsOffIsNotShown() {
    assertThat(beside(LightControl.COLOUR, LightColour.OFF)).isEqualTo(paper());
  }

  @Test
  void anotherVariableOfThatNameIsNoLight() {
    assertThat(beside(Var.of("colour", Shapes.TEXT), "#ff0000")).isEqualTo(paper());
  }
}
