package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.apps.lightpaint.logic.FaultyPainter.Bug.GOES_BACK;
import static org.starl.apps.lightpaint.logic.FaultyPainter.Bug.PAINTS_A_PART_AGAIN;
import static org.starl.apps.lightpaint.logic.FaultyPainter.Bug.PAINTS_TWICE;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.lightpaint.logic.FaultyPainter;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.logic.Strokes;
import org.starl.apps.lightpaint.robot.HouseDrawing;
import org.starl.apps.lightpaint.spec.PaintSpec;
import org.starl.geometry.Point;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;

/** The specification detects each of these planted bugs. */
class FaultyPaintersTest {

  private static SimResult run(FaultyPainter.Bug bug) {
    return run(bug, Strokes.of(HouseDrawing.lines(5), 10, 1200));
  }

  private static SimResult run(FaultyPainter.Bug bug, List<Stroke> strokes) {
    return Simulation.builder()
        .seed(1)
        .endNs(400_000_000_000L)
        .robots(1, gvh -> new FaultyPainter(gvh, strokes, bug))
        .monitor(() -> new PaintSpec(strokes, 25, 350_000_000_000L))
        .build()
        .run();
  }

  @ParameterizedTest
  @CsvSource({
    "KEEPS_ITS_LIGHT_ON, lightpaint.OnTheDrawing",
    "TAKES_ANOTHER_INK, lightpaint.OnTheDrawing",
    "PAINTS_TWICE, lightpaint.Once",
    "GOES_BACK, lightpaint.Once",
    "PAINTS_A_PART_AGAIN, lightpaint.Once",
    "FORGETS_ONE, lightpaint.Complete",
    "NEVER_ENDS, lightpaint.Painted",
  })
  void aFaultyPainterIsSeen(FaultyPainter.Bug bug, String lemma) {
    SimResult result = run(bug);
    assertThat(result.spec().violations(lemma)).as("%s", result.spec()).isPositive();
  }

  @Test
  void aPainterWithoutABugViolatesNothing() {
    SimResult result = run(FaultyPainter.Bug.NONE);
    assertThat(result.spec().violations()).isEmpty();
    for (String lemma : result.spec().lemmas()) {
      assertThat(result.spec().checks(lemma)).as(lemma).isPositive();
    }
  }

  /** One stroke whose parts are nearer to each other than the tolerance. */
  private static List<Stroke> nearItself(String drawing) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i <= 22; i++) {
      double turns = i / 8.0;
      points.add(
          switch (drawing) {
            case "spiral" -> {
              double radiusMm = 30 + 15 * turns;
              double x = radiusMm * StrictMath.cos(2 * StrictMath.PI * turns);
              yield new Point(x, radiusMm * StrictMath.sin(2 * StrictMath.PI * turns));
            }
            case "zigzag" -> new Point(i % 2 * 120, 10 * i);
            case "loops" -> new Point(i * 7 % 3 * 60, i * 5 % 4 * 40 + i);
            default -> throw new IllegalArgumentException(drawing);
          });
    }
    return List.of(new Stroke(0, new Polyline(points), new Ink(0, 5)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"spiral", "zigzag", "loops"})
  void paintingTwiceIsSeenWhereAStrokeIsNearToItself(String drawing) {
    List<Stroke> strokes = nearItself(drawing);
    assertThat(run(FaultyPainter.Bug.NONE, strokes).spec().violations()).isEmpty();
    for (FaultyPainter.Bug bug : List.of(PAINTS_TWICE, GOES_BACK, PAINTS_A_PART_AGAIN)) {
      SimResult result = run(bug, strokes);
      assertThat(result.spec().violations("lightpaint.Once")).as("%s", bug).isPositive();
    }
  }
}
