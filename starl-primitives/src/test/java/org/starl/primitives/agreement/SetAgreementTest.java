package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.id.Participants;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

class SetAgreementTest {

  private static final Codec<Long> NUMBERS =
      new Codec<>() {
        @Override
        public void write(Long message, WireWriter out) {
          out.i64(message);
        }

        @Override
        public Long read(WireReader in) {
          return in.i64();
        }
      };

  /** Proposes, waits until the deadline, and proposes again; returns when it gave up, and the end. */
  private static final class Proposing extends LogicThread {
    private final SetAgreement<Long> agreement;

    Proposing(GlobalVarHolder gvh) {
      super(gvh);
      agreement =
          new SetAgreement<>(
              gvh,
              "number",
              NUMBERS,
              gvh.id.participants(),
              AgreementSettings.DEFAULT.withDeadlineMs(5_000));
    }

    @Override
    public List<Object> callStarL() {
      agreement.propose(7L);
      await(() -> agreement.failed().get());
      long gaveUpNs = gvh.plat.clock.nowNs();
      agreement.propose(7L);
      boolean failedAgain = agreement.failed().get();
      await(() -> agreement.decided().get().isDecided());
      return List.of(gaveUpNs, failedAgain);
    }
  }

  @Test
  void aProposalWithoutAMajorityFailsAtItsDeadlineAndMayBeMadeAgain() {
    SimResult result =
        Simulation.builder()
            .robots(3, Proposing::new)
            .settings(
                SimSettings.builder()
                    .set("faults", "partition(all>all,at=0s,until=8s)")
                    .set("duration", "60s")
                    .build())
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.results().values())
        .hasSize(3)
        .allSatisfy(ended -> assertThat(ended).containsExactly(5_000_000_000L, false));
  }

  /** A robot that is no acceptor, and does not propose. */
  @Test
  void aRobotThatAsksLearnsTheDecision() {
    SimResult result =
        Simulation.builder()
            .robots(4, Asking::new)
            .settings(SimSettings.builder().set("duration", "60s").build())
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.results().values()).containsOnly(List.of(7L));
  }

  private static final class Asking extends LogicThread {
    private final SetAgreement<Long> agreement;
    private final boolean serves;

    Asking(GlobalVarHolder gvh) {
      super(gvh);
      Participants acceptors = Participants.of(gvh.id.participants().asList().subList(0, 3));
      serves = acceptors.contains(gvh.id.name());
      agreement = new SetAgreement<>(gvh, "number", NUMBERS, acceptors);
    }

    @Override
    public List<Object> callStarL() {
      if (serves) {
        agreement.propose(7L);
      } else {
        sleep(5_000);
        agreement.refresh();
      }
      await(() -> agreement.decided().get().isDecided());
      Decision.Decided<Long> decision = (Decision.Decided<Long>) agreement.decided().get();
      sleep(10_000);
      return List.of(decision.value());
    }
  }
}
