package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.RunController;
import org.starl.sim.SimObserver;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.StepListener;
import org.starl.sim.record.Scene;
import org.starl.trace.TraceEvent;

/** What {@code docs/viewer.md} says an app does with a point is compiled, and goes there. */
class ViewerDocTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final Point SENT = new Point(1500, 900);

  private static String withoutSpace(String code) {
    return code.replaceAll("\\s+", "");
  }

  @Test
  void theCodeIsTheOneThatRuns() throws IOException {
    String page = Files.readString(Path.of("../docs/viewer.md"));
    String shown = page.substring(page.indexOf("```java\n") + 8);
    shown = shown.substring(0, shown.indexOf("```"));
    assertThat(shown).contains("receivedPointInput");
    String code = Files.readString(Path.of("src/test/java/org/starl/docs/Errand.java"));
    assertThat(withoutSpace(code)).contains(withoutSpace(shown));
  }

  /** Points once, as soon as the robot knows where it is. */
  private static final class Person implements StepListener {
    private boolean hasPointed;

    @Override
    public void onStep(RunController controller) {
      if (!hasPointed && controller.nowNs() >= 1_000_000_000) {
        hasPointed = true;
        controller.point(BOT, (int) SENT.xMm(), (int) SENT.yMm());
      }
    }
  }

  @Test
  void itDrivesToThePlaceThatIsSent() {
    Scene scene = new Scene(Obstacles.NONE);
    Simulation.builder()
        .name("errand")
        .settings(SimSettings.builder().duration(Duration.ofSeconds(30)).build())
        .seed(7)
        .robots(1, Errand::new)
        .stepListener(new Person())
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                scene.observe(event);
              }
            })
        .build()
        .run();
    Pose end = scene.pose(BOT).orElseThrow();
    assertThat(end.xMm()).isCloseTo(SENT.xMm(), within(80.0));
    assertThat(end.yMm()).isCloseTo(SENT.yMm(), within(80.0));
  }
}
