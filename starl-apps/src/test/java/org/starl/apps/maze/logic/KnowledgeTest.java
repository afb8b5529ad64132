package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.sim.Simulation;

/** What one robot learns from its bumps. */
class KnowledgeTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 20_000, 20_000);
  private static final int PERIOD_MS = 100;

  /** Drives on after each of some bumps, and notes for how long it feels. */
  private static final class Feeler extends LogicThread {
    private final List<Long> feltMs;

    Feeler(GlobalVarHolder gvh, List<Long> feltMs) {
      super(gvh);
      this.feltMs = feltMs;
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      Point start = gvh.gps.pose().at();
      MazeTask task =
          new MazeTask(
              start, List.of(), List.of(), FLOOR, Blocks.of(FLOOR), CollisionMode.DISCOVER);
      Knowledge known = new Knowledge(gvh, task, new Ride(gvh), new Diary(gvh));
      for (int bump = 0; bump < 3; bump++) {
        gvh.plat.moat.doMove(new ItemPosition("far", start.xMm() + 10_000, start.yMm()));
        known.bumped();
        long ms = PERIOD_MS;
        while (!known.hasLearned(PERIOD_MS)) {
          sleep(PERIOD_MS);
          ms += PERIOD_MS;
        }
        feltMs.add(ms);
      }
      return List.of();
    }
  }

  @Test
  void aRobotFeelsAlongAnObstacleForAsLongAfterEachBump() {
    List<Long> feltMs = new ArrayList<>();
    Simulation.builder().seed(1).robots(1, gvh -> new Feeler(gvh, feltMs)).build().run();
    assertThat(feltMs).hasSize(3).containsOnly(CollisionMode.DISCOVER.feelMs());
  }
}
