package org.starl.apps.lightpaint.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.sim.Simulation;

class CurrentWorkTest {

  /** A stroke that leads 60 mm to the right, and back 10 mm above. */
  private static final Stroke HAIRPIN =
      new Stroke(
          0,
          new Polyline(
              List.of(new Point(0, 0), new Point(60, 0), new Point(60, 10), new Point(0, 10))),
          new Ink(1, 1));

  /** Else it would leave out what is between the two places that it may be at. */
  @Test
  void whereAStrokeIsNearToItselfAPainterGoesOnAtTheFirstPlaceThatItMayBeAt() {
    List<Point> next = new ArrayList<>();
    Simulation.builder()
        .seed(1)
        .robots(
            1,
            gvh ->
                new LogicThread(gvh) {
                  @Override
                  public List<Object> callStarL() {
                    CurrentWork work = new CurrentWork(gvh, List.of(HAIRPIN));
                    work.begin(HAIRPIN, new Point(0, 0));
                    work.note(true);
                    for (double errorMm : new double[] {10, 1}) {
                      work.resume(new Point(40, 8), errorMm);
                      next.add(work.next());
                    }
                    return List.of();
                  }
                })
        .build()
        .run();
    assertThat(next.get(0).distanceMm(new Point(40, 0))).isLessThan(0.01);
    assertThat(next.get(1).distanceMm(new Point(40, 10))).isLessThan(0.01);
  }
}
