package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import org.junit.jupiter.api.Test;
import org.starl.primitives.mutex.MutexWorld.ViewFault;
import org.starl.spec.SpecReport;

/** Progress: after all faults, and within the bounds if their assumptions hold. */
class MutexProgressTest {

  @Test
  void inAGoodNetworkAllRequestsAreServed() {
    MutexWorld.Shape shape = new MutexWorld.Shape(3, 3, 3, 0, 0, ViewFault.NONE);
    for (long seed = 0; seed < 300; seed++) {
      MutexWorld world = new MutexWorld(shape, MutexProtocol::new, seed);
      assertThat(world.run(300)).as("seed %d", seed).isEmpty();
      long failures = world.failures;
      // Six in sequence: each asks again within 4 rounds, hears 1 later, holds up to 3 rounds.
      assertThat(world.heal(6 * 10)).as("rounds to serve all, seed %d", seed).isNotNegative();
      assertThat(world.failures).as("failures, seed %d", seed).isEqualTo(failures);
    }
  }

  @Test
  void inAGoodNetworkSurvivorsAreServedOrBlockedByAGhost() {
    MutexWorld.Shape shape = new MutexWorld.Shape(3, 3, 3, 2, 4, ViewFault.NONE);
    long confinements = 0;
    for (long seed = 0; seed < 400; seed++) {
      MutexWorld world = new MutexWorld(shape, MutexProtocol::new, seed);
      assertThat(world.run(300)).as("seed %d", seed).isEmpty();
      long before = world.confinements;
      // Questions for fences are repeated after up to 32 s, which are 128 rounds.
      assertThat(world.heal(300)).as("rounds to serve all, seed %d", seed).isNotNegative();
      assertThat(world.monitors.report().violations()).as("seed %d", seed).isEmpty();
      confinements += world.confinements - before;
    }
    assertThat(confinements).as("confinements after healing").isGreaterThan(50);
  }

  @Test
  void allRequestsAreServedWithinTheBoundsOfTheContract() {
    long served = 0;
    for (long seed = 0; seed < 100; seed++) {
      int members = 2 + (int) (seed % 5);
      int sections = 1 + (int) (seed % 4);
      MutexTimedWorld world = world(members, sections, 1, MutexProtocol::new, seed);
      SpecReport report = world.run(20_000);
      assertThat(report.violations()).as("seed %d", seed).isEmpty();
      assertThat(world.entries.values()).as("entries of each, seed %d", seed).allMatch(n -> n > 5);
      served += report.checks(MutexProgress.SERVED);
    }
    assertThat(served).isGreaterThan(5_000);
  }

  @Test
  void nothingIsOwedBehindAHolderThatIsOverdue() {
    for (long seed = 0; seed < 20; seed++) {
      MutexTimedWorld world = world(4, 1, 20, MutexProtocol::new, seed);
      SpecReport report = world.run(60_000);
      assertThat(report.violations()).as("seed %d", seed).isEmpty();
      assertThat(world.longestWaitNs).isGreaterThan(bounds(4).d2Ns());
    }
  }

  @Test
  void whoMakesDisjointRequestsWaitIsFound() {
    SpecReport report = world(4, 4, 1, OneLock::new, 1).run(20_000);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isPositive();
    assertThat(report.violations(MutexSpec.EXCLUSIVE)).isZero();
  }

  @Test
  void whoForgetsTheRequestsThatItKeptBackIsFound() {
    SpecReport report = world(4, 1, 1, Forgetful::new, 1).run(20_000);
    assertThat(report.violations(MutexProgress.SERVED)).isPositive();
  }

  private static MutexTimedWorld world(
      int members, int sections, int holdFactor, MutexNode.Kind kind, long seed) {
    MutexTimedWorld.Shape shape = new MutexTimedWorld.Shape(members, sections, 100, 20, holdFactor);
    return new MutexTimedWorld(shape, bounds(members), kind, seed);
  }

  private static MutexBounds bounds(int members) {
    return MutexBounds.of(members, 100 * NS_PER_MS, 20 * NS_PER_MS);
  }

  /** One lock for all sections: safe, but against part (c) of the contract. */
  private static class OneLock extends MutexProtocol {
    OneLock(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean defers(MutexMessage.Req req, String section) {
      return phase() == Phase.CRITICAL
          || (phase() == Phase.TRYING && isBefore(ts(), me(), req.ts(), req.from()));
    }
  }

  /** Never answers a deferred request. */
  private static class Forgetful extends MutexProtocol {
    private boolean hasDeferred;

    Forgetful(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean defers(MutexMessage.Req req, String section) {
      hasDeferred |= super.defers(req, section);
      return hasDeferred;
    }
  }
}
