package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexPrim.Occupant;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.FaultPlan;

/** The calls that wait: {@link MutexPrim#acquire}, {@code Registration.register}. */
class AcquireSimTest {

  private static final long MINUTE_MS = 60_000;

  private final List<String> told = new ArrayList<>();

  /** Uses the dock in rounds, for a while each time. */
  private final class Docker extends LogicThread {
    private final Registration reg;
    private final M_Mutex mux;
    private final long timeoutMs;
    private final long holdMs;
    private final int rounds;

    Docker(GlobalVarHolder gvh, long timeoutMs, long holdMs, int rounds) {
      super(gvh);
      reg = new Registration(gvh, "floor");
      mux = new M_Mutex(gvh, "floor");
      this.timeoutMs = timeoutMs;
      this.holdMs = holdMs;
      this.rounds = rounds;
    }

    @Override
    public List<Object> callStarL() {
      if (gvh.id.boot() > 1) {
        mux.standsIn(new TreeSet<>());
      }
      assertThat(reg.register(MINUTE_MS)).isTrue();
      reg.do_register(); // no effect
      for (int round = 0; round < rounds; ) {
        MutexFailure failure = mux.acquire(List.of("dock"), timeoutMs);
        assertThat(mux.held().isEmpty()).isEqualTo(failure != MutexFailure.NONE);
        if (failure == MutexFailure.NONE) {
          round++;
          sleep(holdMs);
          mux.release("dock");
        } else {
          List<Occupant> occupants = mux.occupants();
          told.add(gvh.id.name() + ": " + failure + " " + occupants);
          if (!occupants.isEmpty()) {
            return List.of(round);
          }
        }
      }
      return List.of(rounds);
    }
  }

  private SimResult run(String faults, int robots, long timeoutMs, long holdMs, int rounds) {
    return Simulation.builder()
        .seed(3)
        .settings(SimSettings.builder().duration(Duration.ofMinutes(20)).build())
        .faults(faults.isEmpty() ? FaultPlan.NONE : FaultPlan.parse(faults))
        .robots(robots, gvh -> new Docker(gvh, timeoutMs, holdMs, rounds))
        .monitor(() -> new MutexSpec())
        .monitor(() -> new RegistrationSpec())
        .build()
        .run();
  }

  private static void assertGood(SimResult result, int robots) {
    assertThat(result.spec().holds()).as(result.spec().toString()).isTrue();
    assertThat(result.results()).hasSize(robots);
  }

  @Test
  void eachRobotGetsItsRoundsInALossyNetwork() {
    SimResult result = run("loss(0.3)", 4, 10 * MINUTE_MS, 200, 5);
    assertGood(result, 4);
    assertThat(result.results().values()).containsOnly(List.of(5));
  }

  @Test
  void aRobotThatWasGivenUpRegistersAgainWithoutBeingAsked() {
    // Longer than the time of suspicion: the others fence it.
    SimResult result = run("partition(bot1,at=2s,for=40s)", 3, 10 * MINUTE_MS, 500, 40);
    assertGood(result, 3);
    assertThat(result.results().values()).containsOnly(List.of(40));
    assertThat(result.endNs()).isGreaterThan(42_000_000_000L);
  }

  @Test
  void aTimeoutWithdrawsAndTheRobotCanAskAgain() {
    SimResult result = run("", 3, 1_000, 3_000, 3);
    assertGood(result, 3);
    assertThat(told).isNotEmpty().allMatch(line -> line.endsWith(": WITHDRAWN []"));
  }

  @Test
  void whoIsInTheWayIsNamedWithItsSectionsAndTheTime() {
    // bot0 holds the dock for ever.
    SimResult result =
        Simulation.builder()
            .seed(3)
            .faults(FaultPlan.parse("crash(bot0,at=8s)"))
            .robots(3, gvh -> new Docker(gvh, 40_000, isFirst(gvh) ? 1_000_000 : 100, 1_000))
            .monitor(() -> new MutexSpec())
            .build()
            .run();
    assertThat(result.spec().holds()).as(result.spec().toString()).isTrue();
    assertThat(told)
        .hasSize(2)
        .allSatisfy(line ->
            assertThat(line)
                .matches("bot[12]: OCCUPIED \\[bot0 in \\[dock\\] since \\d+\\.\\d s\\]"));
  }

  /** bot2 restarts at 20 s, and so the view changes. */
  @Test
  void aLaterViewIsNoLaterTime() {
    Simulation.builder()
        .seed(3)
        .faults(FaultPlan.parse("crash(bot0,at=8s);crash(bot2,at=20s,restart=1s)"))
        .robots(3, gvh -> new Docker(gvh, 40_000, isFirst(gvh) ? 1_000_000 : 100, 1_000))
        .build()
        .run();
    assertThat(told).anyMatch(line -> line.matches("bot1: .*since (9|1\\d)\\.\\d s\\]"));
  }

  private static boolean isFirst(GlobalVarHolder gvh) {
    return gvh.id.name().equals(new RobotId("bot0"));
  }
}
