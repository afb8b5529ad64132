package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.lightpaint.logic.FaultyPainter;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.logic.Strokes;
import org.starl.apps.lightpaint.robot.HouseDrawing;
import org.starl.apps.lightpaint.spec.PaintSpec;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;

/** The specification detects each of these planted bugs. */
class FaultyPaintersTest {

  private static SimResult run(FaultyPainter.Bug bug) {
    List<Stroke> strokes = Strokes.of(HouseDrawing.lines(5), 10, 1200);
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
}
