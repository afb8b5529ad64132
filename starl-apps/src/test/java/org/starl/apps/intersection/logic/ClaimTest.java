package org.starl.apps.intersection.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/** Claims of three robots that do not drive. */
class ClaimTest {

  private interface Part {
    void play(Robot robot, Claim claim);
  }

  private static final class Robot extends LogicThread {
    private final Part part;

    Robot(GlobalVarHolder gvh, Part part) {
      super(gvh);
      this.part = part;
    }

    @Override
    public List<Object> callStarL() {
      Claim claim = new Claim(gvh, "crossing", gvh.id.participants(), () -> true);
      part.play(this, claim);
      stepUntil(claim, () -> false, 200);
      return List.of();
    }

    boolean is(int number) {
      return gvh.id.name().equals(gvh.id.participants().asList().get(number));
    }

    boolean isRestarted() {
      return gvh.id.boot() > 1;
    }

    /** Whether the condition holds by then; a claim takes a step in each period. */
    boolean stepUntil(Claim claim, BooleanSupplier condition, int atS) {
      claim.step();
      while (!condition.getAsBoolean() && gvh.plat.clock.nowNs() < atS * Time.NS_PER_S) {
        sleep(50);
        claim.step();
      }
      return condition.getAsBoolean();
    }
  }

  private static void play(String faults, Part part) {
    Simulation.builder()
        .seed(1)
        .settings(SimSettings.builder().set("faults", faults).set("duration", "250s").build())
        .robots(3, gvh -> new Robot(gvh, part))
        .build()
        .run();
  }

  @Test
  void anUnregistrationThatFailsIsTriedAgain() {
    List<Boolean> seen = new ArrayList<>();
    play(
        "partition(bot0,at=20s,until=80s)",
        (robot, claim) -> {
          if (robot.is(0)) {
            claim.want(List.of("A"));
            seen.add(robot.stepUntil(claim, () -> claim.held().contains("A"), 20));
            robot.stepUntil(claim, () -> false, 21);
            claim.leave("A");
            seen.add(robot.stepUntil(claim, claim::isOver, 79));
            seen.add(robot.stepUntil(claim, claim::isOver, 180));
          }
        });
    assertThat(seen).containsExactly(true, false, true);
  }

  @Test
  void aRestartedRobotIsNotOverWhileItsEarlierIdIsListed() {
    List<Boolean> seen = new ArrayList<>();
    play(
        "crash(bot0,at=20s,restart=2s)",
        (robot, claim) -> {
          if (robot.is(0) && robot.isRestarted()) {
            claim.resume(List.of(), List.of());
            seen.add(claim.isOver());
            seen.add(robot.stepUntil(claim, claim::isOver, 180));
          } else if (robot.is(0)) {
            claim.want(List.of("A"));
          }
        });
    assertThat(seen).containsExactly(false, true);
  }
}
