package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.id.Participants;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.TraceRecorder;
import org.starl.sim.kernel.CarrierKind;

/** Registration and agreement on simulated robots, through their gvh. */
class RegistrationSimTest {

  private static final long S = 1_000_000_000;

  /** Registers, stays for a while, unregisters, and returns how many it was among. */
  private static final class Guest extends LogicThread {
    private final RegPrim reg;

    Guest(GlobalVarHolder gvh) {
      super(gvh);
      reg = new Registration(gvh, "inn");
    }

    @Override
    public List<Object> callStarL() {
      sleep(gvh.plat.entropy.fork("guest").nextLong(0, 3_000));
      do {
        reg.do_register();
        await(() -> reg.getList() != null || reg.failed().get());
      } while (reg.failed().get());
      Participants list = reg.getList();
      int among = list == null ? 0 : list.size();
      sleep(2_000);
      reg.unregister();
      await(() -> reg.isUnregistered() || reg.failed().get());
      return List.of(among, reg.isUnregistered());
    }
  }

  /** Proposes its own name, and returns what was decided. */
  private static final class Voter extends LogicThread {
    private final SetAgreement<String> agreement;

    Voter(GlobalVarHolder gvh) {
      super(gvh);
      agreement = new SetAgreement<>(gvh, "colour", Codec.text());
    }

    @Override
    public List<Object> callStarL() {
      agreement.propose(gvh.id.name().name());
      await(() -> agreement.decided().get().isDecided() || agreement.failed().get());
      return List.of(agreement.decided().get());
    }
  }

  private static SimSettings settings(String loss, String delay) {
    return SimSettings.builder()
        .set("messageLoss", loss)
        .set("messageDelay", delay)
        .set("duration", "120s")
        .build();
  }

  private static Simulation.Builder guests(long seed) {
    return Simulation.builder()
        .name("guests")
        .seed(seed)
        .robots(6, Guest::new)
        .settings(settings("0.3", "uniform(10ms,200ms)"))
        .monitor(() -> new RegistrationSpec(30 * S));
  }

  @Property(tries = 20)
  void robotsRegisterAndUnregisterUnderLoss(@ForAll long seed) {
    SimResult result = guests(seed).build().run();
    assertThat(result.isFinished()).as("unfinished: %s", result.unfinished()).isTrue();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.spec().checks(RegistrationSpec.KEEPS)).isPositive();
    assertThat(result.results().values())
        .allSatisfy(ended -> {
          assertThat((Integer) ended.get(0)).isPositive();
          assertThat(ended.get(1)).isEqualTo(true);
        });
  }

  @Test
  void equalSeedsGiveEqualTracesOnBothCarriers() {
    String trace = trace(guests(7).carriers(CarrierKind.PLATFORM));
    assertThat(trace).contains("do_register").contains("unregister").contains("rList");
    assertThat(trace(guests(7).carriers(CarrierKind.best()))).isEqualTo(trace);
    assertThat(trace(guests(8).carriers(CarrierKind.best()))).isNotEqualTo(trace);
  }

  @Property(tries = 20)
  void votersAgreeOnOneOfTheirNames(@ForAll long seed) {
    SimResult result =
        Simulation.builder()
            .name("voters")
            .seed(seed)
            .robots(5, Voter::new)
            .settings(settings("0.3", "uniform(10ms,200ms)"))
            .monitor(AgreementSpec::new)
            .build()
            .run();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.results().values().stream().distinct()).hasSize(1);
    assertThat(result.results().values())
        .allSatisfy(ended ->
            assertThat((Decision<?>) ended.get(0))
                .isInstanceOfSatisfying(
                    Decision.Decided.class,
                    decided -> assertThat(decided.value()).asString().matches("bot[0-4]")));
  }

  private static String trace(Simulation.Builder builder) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(bytes)) {
      builder.observer(recorder).build().run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }
}
