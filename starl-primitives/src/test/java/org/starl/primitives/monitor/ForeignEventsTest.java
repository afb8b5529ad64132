package org.starl.primitives.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.spec.Monitor;
import org.starl.trace.Note;

/** Specifications of primitives that an app does not use, and what the app itself says. */
class ForeignEventsTest {

  private static final List<Supplier<Monitor>> ALL =
      List.of(
          AgreementSpec::new,
          BarrierSpec::new,
          ElectionSpec::new,
          GeocastSpec::new,
          LedgerSpec::new,
          MotionSpec::new,
          MutexSpec::new,
          RegistrationSpec::new,
          TubesSpec::new);

  /** Tells all robots a text. */
  private static final class Teller extends LogicThread {
    private final Broadcast<String> news;

    Teller(GlobalVarHolder gvh) {
      super(gvh);
      news = new Broadcast<>(gvh, "news", Codec.text(), (from, text) -> {});
    }

    @Override
    public List<Object> callStarL() {
      news.BCast("bot0 Req[num=1]", 1_000);
      sleep(2_000);
      return List.of();
    }
  }

  /** Says in words what it does. */
  private static final class Painter extends LogicThread {
    Painter(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      gvh.trace.action("app", "paint", gvh.id.name() + "#red");
      gvh.trace.action("mutex", "do_mutex", gvh.id.name() + "#red", "1", "x");
      return List.of();
    }
  }

  private static Simulation.Builder two(Function<GlobalVarHolder, LogicThread> app) {
    return Simulation.builder().seed(1).robots(2, app::apply);
  }

  @Test
  void aBroadcastDisturbsNoSpecification() {
    Simulation.Builder simulation = two(Teller::new);
    ALL.forEach(simulation::monitor);
    SimResult result = simulation.build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.spec().checks("geocast.once")).isPositive();
  }

  @Test
  void wordsOfAnAppDisturbNoSpecification() {
    Simulation.Builder simulation = two(Painter::new);
    ALL.forEach(simulation::monitor);
    SimResult result = simulation.build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
  }

  @Test
  void wordsCannotPassForFactsOfAPrimitive() {
    Simulation simulation =
        two(
                gvh -> {
                  gvh.trace.action("mutex/crossing", "do_mutex", "A");
                  return new Painter(gvh);
                })
            .build();
    assertThatThrownBy(simulation::run)
        .hasStackTraceContaining("words of 'mutex/crossing': expected app or a part of it");
  }

  /** A monitor with a bug. */
  private static final class Broken extends AppMonitor {
    Broken() {
      lemma("never", "Not reached.");
    }

    @Override
    protected void onJoined(RobotId robot) {
      throw new ArithmeticException("the bug");
    }
  }

  @Test
  void aMonitorThatThrowsIsNamedWithTheEvent() {
    Simulation simulation = two(Painter::new).monitor(Broken::new).build();
    assertThatThrownBy(simulation::run)
        .hasStackTraceContaining("the monitor " + Broken.class.getName() + " failed at Joined[")
        .hasStackTraceContaining("the bug");
  }

  /** A monitor with a bug that an app's action meets. */
  private static final class BrokenAtAction extends AppMonitor {
    BrokenAtAction() {
      lemma("never", "Not reached.");
      on(
          Note.class,
          (robot, note) -> {
            throw new ArithmeticException("the bug");
          });
    }
  }

  @Test
  void theAppIsNotBlamedForAMonitor() {
    Simulation simulation = two(Painter::new).monitor(BrokenAtAction::new).build();
    assertThatThrownBy(simulation::run)
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContaining("the monitor " + BrokenAtAction.class.getName());
  }
}
