package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_S;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/** The specification on handwritten traces, with a bound of 5 s; the world is calm after 10 s. */
class ServiceSpecTest {

  private static final RobotId BOT = new RobotId("bot0");

  private Monitors monitors = new Monitors(List.of(new ServiceSpec(5 * NS_PER_S, false)));

  private void act(long atS, ClientFact fact) {
    monitors.observe(
        TraceEvent.Action.of(atS * NS_PER_S, BOT, ClientFact.SOURCE, ClientFact.SHAPE, fact));
  }

  private void fault(long atS, String name) {
    monitors.observe(new TraceEvent.Fault(atS * NS_PER_S, TraceEvent.Fault.WORLD, name, "loss(1)"));
  }

  private SpecReport end(long atS) {
    monitors.finish(atS * NS_PER_S);
    return monitors.report();
  }

  @Test
  void aRequestWithoutAnAnswerViolatesPrompt() {
    act(1, new ClientFact.ask(1));
    assertThat(end(7).violations("service.Prompt")).isEqualTo(1);
  }

  @Test
  void aFailureViolatesGrantedUnlessThePrimitiveMayFail() {
    act(1, new ClientFact.ask(1));
    act(2, new ClientFact.told(1));
    assertThat(end(9).violations("service.Granted")).isEqualTo(1);
    assertThat(monitors.report().violations("service.Prompt")).isZero();
    monitors = new Monitors(List.of(new ServiceSpec(5 * NS_PER_S, true)));
    act(1, new ClientFact.ask(1));
    act(2, new ClientFact.told(1));
    assertThat(end(9).lemmas()).containsExactly("service.Prompt");
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aWaitThatEndsTooLateInACalmWorldViolatesPrompt() {
    fault(1, "begin");
    act(2, new ClientFact.late(1, 0));
    fault(3, "end");
    act(12, new ClientFact.late(1, 0));
    act(20, new ClientFact.late(1, 8000)); // begun when the world was not calm yet
    assertThat(monitors.report().violations("service.Prompt")).isZero();
    act(21, new ClientFact.late(1, 7000));
    assertThat(end(22).violations("service.Prompt")).isEqualTo(1);
  }

  @Test
  void nothingIsOwedToARequestThatAFaultMeets() {
    act(1, new ClientFact.ask(1));
    fault(2, "begin");
    fault(3, "end");
    act(14, new ClientFact.told(1));
    act(14, new ClientFact.ask(1));
    assertThat(end(18).checks("service.Granted")).isZero();
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void serviceIsOwedAgainWhenTheWorldHasBeenCalm() {
    fault(2, "begin");
    fault(3, "end");
    act(12, new ClientFact.ask(1));
    act(13, new ClientFact.ask(1));
    assertThat(end(19).violations("service.Prompt")).isEqualTo(1);
  }
}
