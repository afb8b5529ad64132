package org.starl.apps.lightpaint.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.sim.Simulation;

/** Which strokes a painter leaves to others. */
class AssignmentTest {

  private static final long SECOND_NS = 1_000_000_000;

  private static final List<Stroke> STROKES =
      List.of(
          new Stroke(0, line(0), new Ink(1, 1)),
          new Stroke(1, line(100), new Ink(1, 1)),
          new Stroke(2, line(3_000), new Ink(1, 1)));

  private static Polyline line(double yMm) {
    return new Polyline(List.of(new Point(0, yMm), new Point(1_000, yMm)));
  }

  /** The first of two painters works at the first stroke, and tells so once; the second one looks. */
  @Test
  void aStrokeIsContestedWhileHintsAreNewAndAPostponedOneIsLeftAloneForItsTime() {
    Point here = new Point(0, 0);
    List<Object> seen = new ArrayList<>();
    Simulation.builder()
        .seed(1)
        .robots(
            2,
            gvh ->
                new LogicThread(gvh) {
                  @Override
                  public List<Object> callStarL() {
                    Assignment assignment = new Assignment(gvh, STROKES, 500);
                    if (gvh.id.name().equals(gvh.id.participants().asList().get(0))) {
                      assignment.sendHint(0, false, here);
                      return List.of();
                    }
                    sleep(5_000);
                    seen.add(assignment.nearestFree(here, any -> true).number());
                    assignment.postpone(STROKES.get(2), 5 * SECOND_NS);
                    seen.add(assignment.nearestFree(here, any -> true) == null);
                    sleep(6_000);
                    seen.add(assignment.nearestFree(here, any -> true).number());
                    sleep(10_000);
                    seen.add(assignment.nearestFree(here, any -> true).number());
                    return List.of();
                  }
                })
        .build()
        .run();
    assertThat(seen).containsExactly(2, true, 2, 0);
  }

  /** The first one of two has been assigned its stroke: the second one waits, which is near to it. */
  @Test
  void aPainterWaitsForOneWithASmallerNameThatPaintsNearByAndNotTheOtherWayRound() {
    List<Object> seen = new ArrayList<>();
    Simulation.builder()
        .seed(1)
        .robots(
            2,
            gvh ->
                new LogicThread(gvh) {
                  @Override
                  public List<Object> callStarL() {
                    Assignment assignment = new Assignment(gvh, STROKES, 500);
                    int own = gvh.id.participants().asList().indexOf(gvh.id.name());
                    assignment.request(STROKES.get(own));
                    await(() -> assignment.isOwn(STROKES.get(own)));
                    assignment.sendHint(own, false, new Point(0, 0));
                    sleep(3_000);
                    seen.add(gvh.id.name() + " " + assignment.mustWait(STROKES.get(own)));
                    seen.add(gvh.id.name() + " " + assignment.mustWait(STROKES.get(2)));
                    return List.of();
                  }
                })
        .build()
        .run();
    assertThat(seen)
        .containsExactlyInAnyOrder("bot0 false", "bot0 false", "bot1 true", "bot1 false");
  }
}
